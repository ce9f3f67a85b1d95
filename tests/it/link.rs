//! `driftpost link` against the double: what a user sees, and the independent judge of a program's targets.

mod loading;
mod reach;

use assert_cmd::Command;
use driftpost::application::{LinkCheck, LinkChecked};
use driftpost::{Compensation, Deformation, ProgramFiles, Robot};
use rapid_program::{Overrides, Program};
use robot_link::{Credentials, Host, Pins, Session, Settings, Unit};
use rws_double::{Double, Holder, Operator, Options, Personality, Planted};
use std::path::{Path, PathBuf};
use std::sync::LazyLock;
use std::time::{Duration, Instant};

const CUBE: &str = "fixtures/robodk/irc5/Cube45.mod";

fn double(personality: Personality) -> Double {
    Double::start(&Options { least_gap: Duration::ZERO, ..Options::new(personality) }).unwrap()
}

/// The test of all cases at the same time: most of what it takes is the client's pace between two requests.
fn side_by_side<T: Send>(cases: impl IntoIterator<Item = T>, test: impl Fn(T) + Sync) {
    let test = &test;
    std::thread::scope(|scope| {
        for case in cases {
            scope.spawn(move || test(case));
        }
    });
}

fn on_each_robotware(test: impl Fn(Personality) + Sync) {
    side_by_side(Personality::ALL, test);
}

/// Cube45 as exported, and corrected with arrays.
static PROGRAMS: LazyLock<[Vec<u8>; 2]> = LazyLock::new(|| {
    let bytes = std::fs::read(Path::new(env!("CARGO_MANIFEST_DIR")).join(CUBE)).unwrap();
    let compensation = Compensation::new(Robot::built_in("irb140").unwrap(), Deformation::paper());
    let corrected = compensation.run(&ProgramFiles::one("Cube45.mod", bytes.clone())).unwrap();
    let corrected = corrected.text().unwrap().to_vec();
    [bytes, corrected]
});

fn check(double: &Double, program: &[u8]) -> LinkChecked {
    let host = Host::parse(&double.root()).unwrap();
    let user = Credentials::new("Default User", "robotics");
    let settings = Settings { pace: Duration::ZERO, ..Settings::default() };
    let mut session = Session::open(&host, &user, &mut Pins::in_memory(), &settings).unwrap();
    let files = ProgramFiles::one("Cube45.mod", program.to_vec()).sources();
    let program = Program::read(files, &Overrides::default());
    let check = LinkCheck::new(Unit::new("ROB_1").unwrap());
    let checked = check.run(&mut session, &program, &Robot::built_in("irb140").unwrap(), None).unwrap();
    session.end().unwrap();
    assert_eq!((double.hits(), double.sessions()), (Vec::new(), 0));
    checked
}

/// The double calculates with rs-opw-kinematics and lengths of ABB's data sheet; the original has 46 targets, the corrected one
/// 22 elements for each, of which three are asked for.
#[test]
fn every_target_of_cube45_is_confirmed_by_other_kinematics() {
    on_each_robotware(|personality| {
        for (program, count) in PROGRAMS.iter().zip([46, 138]) {
            let checked = check(&double(personality), program);
            assert_eq!(checked.agrees(), Some(true), "{}", checked.text(false));
            let LinkChecked::Asked { found, unknown, .. } = checked else { panic!("it is offered") };
            assert_eq!((found.len(), unknown), (count, 0));
            // What is left is the single precision of the answers.
            assert!(found.iter().all(|f| f.apart.0 < 0.0005 && f.joints_deg.unwrap() < 0.0002));
            // The wrist turned over reaches a pose, too.
            let all = found.iter().map(|f| f.all_solutions.unwrap());
            assert!(all.clone().all(|all| all.has_ours && (2..=8).contains(&all.count)), "{found:?}");
        }
    });
}

#[test]
fn a_planted_hundredth_of_a_millimetre_is_found() {
    let double = double(Personality::Rw7);
    double.plant(Planted { shift_m: [0.0, 0.000_01, 0.0], ..Planted::default() });
    let checked = check(&double, &PROGRAMS[1]);
    assert_eq!(checked.agrees(), Some(false));
    let LinkChecked::Asked { found, .. } = checked else { panic!("it is offered") };
    assert!(found.iter().all(|f| !f.agrees && (f.apart.0 - 0.01).abs() < 0.0005), "{found:?}");
}

#[test]
fn a_planted_wrong_branch_is_found() {
    on_each_robotware(|personality| {
        let double = double(personality);
        double.plant(Planted { other_branch: true, ..Planted::default() });
        let checked = check(&double, &PROGRAMS[0]);
        assert_eq!(checked.agrees(), Some(false));
        let LinkChecked::Asked { found, .. } = &checked else { panic!("it is offered") };
        assert!(
            found.iter().all(|f| f.apart.0 < 0.0005 && f.joints_deg.is_none_or(|deg| deg > 1.0)),
            "{found:?}"
        );
        assert!(found.iter().any(|f| !f.agrees) && checked.text(false).contains("DO NOT AGREE"));
        // Where it goes to is another branch; that there is ours the controller knows.
        assert!(found.iter().all(|f| f.all_solutions.is_some_and(|all| all.has_ours)), "{found:?}");
        assert!(checked.text(false).contains("ours among them"), "{}", checked.text(false));
    });
}

#[test]
fn a_controller_that_does_not_calculate_is_no_failure() {
    let double = double(Personality::Rw6);
    double.with(|c| c.offers_kinematics = false);
    let checked = check(&double, &PROGRAMS[0]);
    assert!(matches!(checked, LinkChecked::NotOffered(_)) && checked.text(false).starts_with("not offered"));
}

/// A shop: a corrected module in a folder, a double with it loaded, and a user at a command line.
struct Shop {
    folder: tempfile::TempDir,
    double: Double,
}

impl Shop {
    fn new(personality: Personality) -> Self {
        let shop = Self {
            folder: tempfile::tempdir().unwrap(),
            double: Double::start(&Options::new(personality)).unwrap(),
        };
        let corrected = &PROGRAMS[1];
        std::fs::write(shop.module(), corrected).unwrap();
        let text = String::from_utf8_lossy(corrected).replace("tcMinute:=0", "tcMinute:=64.7");
        shop.double.with(|c| c.load(&text, "ProgMod"));
        shop
    }

    fn module(&self) -> PathBuf {
        self.folder.path().join("Cube45.mod")
    }

    /// What the task holds of modules of a user: this one, or none.
    fn put(&self, text: Option<&str>) {
        self.double.with(|c| {
            c.modules.retain(|m| !m.name.starts_with("MOD_"));
            text.into_iter().for_each(|text| c.load(text, "ProgMod"));
        });
    }

    /// The names of a user's modules in the task.
    fn loaded(&self) -> Vec<String> {
        let names = self.double.with(|c| c.modules.iter().map(|m| m.name.clone()).collect::<Vec<_>>());
        names.into_iter().filter(|name| name.starts_with("MOD_")).collect()
    }

    /// Exit code, standard output and standard error.
    fn run(&self, arguments: &[&str]) -> (i32, String, String) {
        let root = self.double.root();
        let module = self.module().display().to_string();
        let arguments = arguments.iter().map(|a| a.replace("HOST", &root).replace("MODULE", &module));
        let output = Command::cargo_bin("driftpost")
            .unwrap()
            .arg("link")
            .args(arguments)
            .env("DRIFTPOST_LINK_KNOWN", self.folder.path().join("known"))
            .env("DRIFTPOST_LINK_PASSWORD", "robotics")
            .output()
            .unwrap();
        let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
        assert_eq!(
            (self.double.hits(), self.double.sessions()),
            (Vec::new(), 0),
            "{arguments:?}",
            arguments = self.double.requests()
        );
        assert!(
            !text(&output.stderr).contains("robotics") && !text(&output.stdout).contains("robotics"),
            "no password is shown"
        );
        (output.status.code().unwrap(), text(&output.stdout), text(&output.stderr))
    }
}

/// The data that stand in a page.
fn data_of(page: &Path) -> serde_json::Value {
    let text = std::fs::read_to_string(page).unwrap();
    let (_, rest) = text.split_once("<script type=\"application/json\" id=\"data\">").unwrap();
    let (data, rest) = rest.split_once("</script>").unwrap();
    assert!(rest.trim_end().ends_with("</html>"), "a page is there whole");
    serde_json::from_str(data).unwrap()
}

/// The table as it is in the program that is shipped: every request that it can send is one that the double lets pass.
#[test]
fn the_binarys_table_of_requests_holds_none_that_could_move_the_robot() {
    let output = Command::cargo_bin("driftpost").unwrap().args(["link", "requests"]).output().unwrap();
    let text = String::from_utf8(output.stdout).unwrap();
    let forms: Vec<&str> = text
        .lines()
        .filter_map(|line| line.strip_prefix("  ")?.split_once(": ").map(|(_, form)| form))
        .collect();
    assert_eq!(forms.len(), 3 * robot_link::requests::ALL.len());
    let written: Vec<&&str> =
        forms.iter().filter(|form| !form.starts_with("GET ") && **form != "-").collect();
    let harmless = [
        "CalcPoseFromJoints",
        "JointsFromCartesian",
        "AllJointSolutions",
        "/pose-from-joints",
        "/joints-from-cartesian",
        "/all-joints-solution",
        "/{name}?action=set value=",
        "/{name}/data value=",
        "PUT /fileservice/{home}/{file}",
        "loadmod",
        "/mastership/rapid?action=request",
        "/mastership/rapid?action=release",
        "/mastership/edit/request",
        "/mastership/edit/release",
        "/controlstation/writeaccess/",
        "/controlstation/register/remote",
        "/users/rmmp privilege=modify",
        "/users/rmmp?action=cancel",
        "/users/rmmp/cancel",
        "POST /subscription ",
        "DELETE /subscription/{group}",
    ];
    let other: Vec<_> =
        written.iter().filter(|form| !harmless.iter().any(|word| form.contains(word))).collect();
    assert!(written.len() > 30 && other.is_empty(), "{other:?}");
    for word in [
        "start",
        "stop",
        "jog",
        "pcp",
        "ctrlstate?",
        "restart",
        "/cfg",
        "resetpp",
        "motoron",
        "speedratio",
        "iosystem",
        "backup",
    ] {
        assert!(!written.iter().any(|form| form.contains(word)), "{word}");
    }
}

/// Those that take seconds: `cargo test --test it -- --ignored long::`.
mod long {
    use super::*;

    #[test]
    #[ignore = "long"]
    fn a_corrected_module_is_pushed_loaded_and_set() {
        on_each_robotware(|personality| {
            let shop = Shop::new(personality);
            let (code, out, _) = shop.run(&["push", "MODULE", "HOST"]);
            assert!(
                code == 1 && out.contains("new in HOME") && out.contains("dry run: nothing was written"),
                "{out}"
            );
            assert!(shop.double.with(|c| c.files.is_empty()));
            let (code, out, _) = shop.run(&["push", "MODULE", "HOST", "--yes"]);
            assert!(code == 0 && out.contains("read back, the same"), "{out}");
            assert_eq!(
                shop.double.with(|c| c.files["Cube45.mod"].clone()),
                std::fs::read(shop.module()).unwrap()
            );
            let (code, out, _) = shop.run(&["push", "MODULE", "HOST"]);
            assert!(code == 0 && out.contains("is in HOME already"), "{out}");
            // Nobody is there to be asked again.
            let (code, _, message) = shop.run(&["push", "MODULE", "HOST", "--yes", "--load"]);
            assert!(code == 2 && message.contains("nothing was loaded"), "{message}");
            shop.double.with(|c| c.execution = "running");
            let (code, _, message) = shop.run(&["push", "MODULE", "HOST", "--yes", "--load", "--confirmed"]);
            assert!(code == 2 && message.contains("link::running"), "{message}");
            shop.double.with(|c| c.execution = "stopped");
            let (code, out, message) =
                shop.run(&["push", "MODULE", "HOST", "--yes", "--load", "--confirmed"]);
            assert!(
                code == 0 && out.contains("loaded into T_ROB1") && message.contains("`tcStartAt 64.7`"),
                "{out}{message}"
            );
            assert_eq!(shop.double.with(|c| c.value("MOD_Cube45", "tcMinute")).as_deref(), Some("0"));
            let (code, out, _) = shop.run(&["set", "HOST", "tcMode", "20"]);
            assert!(code == 0 && out.contains("tcMode 20 (was -1; read back)"), "{out}");
            let (code, out, _) = shop.run(&["get", "HOST", "tcMode", "tcState{2}"]);
            assert_eq!(
                (code, out.as_str()),
                (0, "T_ROB1/MOD_Cube45 tcMode 20\nT_ROB1/MOD_Cube45 tcState{2} 0\n")
            );
            let json = |arguments: &[&str]| {
                let (code, out, message) = shop.run(&[arguments, &["--json", "-"]].concat());
                assert_eq!(code, 0, "{message}");
                serde_json::from_str::<serde_json::Value>(&out).unwrap()
            };
            let set = json(&["set", "HOST", "tcMode", "-1"]);
            assert_eq!((&set["before"], &set["value"]), (&"20".into(), &"-1".into()), "{set}");
            let got = json(&["get", "HOST", "tcMode"]);
            assert_eq!(
                (&got["data"][0]["name"], &got["data"][0]["value"]),
                (&"tcMode".into(), &"-1".into()),
                "{got}"
            );
        });
    }

    #[test]
    #[ignore = "long"]
    fn what_is_not_ours_stays_as_it_is() {
        let shop = Shop::new(Personality::Rw7);
        for arguments in [
            &["set", "HOST", "baseCount", "1"][..],
            &["get", "HOST", "baseText"],
            &["set", "HOST", "tcModeSeen", "1"],
        ] {
            let (code, _, message) = shop.run(arguments);
            assert!(
                code == 2 && (message.contains("link::not-ours") || message.contains("link::value")),
                "{message}"
            );
        }
        shop.double.with(|c| {
            c.modules.retain(|m| m.name != "MOD_Cube45");
            c.load(&String::from_utf8_lossy(&PROGRAMS[0]), "ProgMod");
        });
        let (code, _, message) = shop.run(&["push", "MODULE", "HOST", "--yes", "--load", "--confirmed"]);
        assert!(code == 2 && message.contains("link::not-ours"), "{message}");
        assert!(!shop.double.requests().iter().any(|r| r.contains("loadmod")));
    }

    #[test]
    #[ignore = "long"]
    fn a_program_is_watched_line_by_line_and_by_subscription() {
        on_each_robotware(|personality| {
            let shop = Shop::new(personality);
            let (code, out, _) = shop.run(&["watch", "HOST", "--count", "2", "--interval-s", "0.1"]);
            assert_eq!((code, out.lines().count()), (0, 2), "{out}");
            assert!(out.starts_with("T_ROB1/MOD_Cube45: tcMode -1, tcBucket -1, tcMinute 64.7"), "{out}");
            let (code, out, _) = shop.run(&["watch", "HOST", "--count", "1", "--subscribe", "--json"]);
            let line: serde_json::Value = serde_json::from_str(out.trim()).unwrap();
            assert_eq!((code, line["values"]["tcMinute"].as_f64()), (0, Some(64.7)));
            shop.double.with(|c| c.offers_subscriptions = false);
            let (code, _, message) = shop.run(&["watch", "HOST", "--count", "1", "--subscribe"]);
            assert!(code == 0 && message.contains("note: no subscription"), "{message}");
        });
    }

    /// The page holds the same records as the lines; what fails on the way is a warning of it, and at its end it says so.
    #[test]
    #[ignore = "long"]
    fn a_watch_writes_a_page_of_its_records() {
        on_each_robotware(|personality| {
            let shop = Shop::new(personality);
            let page = shop.folder.path().join("watch.html");
            let name = page.display().to_string();
            let watch = ["watch", "HOST", "--count", "3", "--interval-s", "0.1", "--json", "--report", &name];
            let (code, out, _) = shop.run(&watch);
            let lines: Vec<serde_json::Value> =
                out.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
            let written = data_of(&page);
            assert_eq!((code, lines.len(), written["command"].as_str()), (0, 3, Some("link watch")));
            assert_eq!(written["data"]["records"].as_array().unwrap(), &lines);
            assert_eq!(written["data"]["ended"], "The watch has ended.");
            assert_eq!(written["data"]["warnings"], serde_json::json!([]));

            // A page that cannot be written is told before anybody logs in.
            let before = shop.double.requests().len();
            let folder = shop.folder.path().display().to_string();
            let (code, _, message) = shop.run(&["watch", "HOST", "--count", "1", "--report", &folder]);
            assert!(code == 2 && message.contains("output::unwritable"), "{message}");
            assert_eq!(shop.double.requests().len(), before);
        });
    }

    /// Ctrl-C while the operator is asked, and while the program is watched: nothing held, logged out, 130 as a shell says it.
    #[cfg(unix)]
    #[test]
    #[ignore = "long"]
    fn an_interrupted_command_gives_back_and_logs_out() {
        on_each_robotware(|personality| {
            let shop = Shop::new(personality);
            let mut commands = vec![vec!["watch", "HOST"], vec!["watch", "HOST", "--subscribe"]];
            if personality != Personality::Rw8 {
                commands.push(vec!["set", "HOST", "tcMode", "20"]);
            }
            for arguments in commands {
                shop.double.with(|c| (c.mode, c.operator) = ("MANR", Operator::Silent));
                let root = shop.double.root();
                let mut child = std::process::Command::new(env!("CARGO_BIN_EXE_driftpost"))
                    .arg("link")
                    .args(arguments.iter().map(|a| a.replace("HOST", &root)))
                    .env("DRIFTPOST_LINK_KNOWN", shop.folder.path().join("known"))
                    .stdin(std::process::Stdio::null())
                    .stdout(std::process::Stdio::null())
                    .stderr(std::process::Stdio::null())
                    .spawn()
                    .unwrap();
                // In the middle: a value is being watched, or the operator asked.
                let is_at_work =
                    |r: &String| r.contains("tcMinute") && r.ends_with(" 200") || r.contains("rmmp/poll");
                let before = shop.double.requests().len();
                let until = Instant::now() + Duration::from_secs(20);
                while !shop.double.requests()[before..].iter().any(is_at_work) {
                    assert!(Instant::now() < until, "{arguments:?}: {:?}", shop.double.requests());
                    std::thread::sleep(Duration::from_millis(5));
                }
                let sent = std::process::Command::new("kill")
                    .args(["-INT", &child.id().to_string()])
                    .status()
                    .unwrap();
                assert!(sent.success());
                let status = child.wait().unwrap();
                assert!(matches!(status.code(), Some(0 | 130)), "{arguments:?}: {status}");
                assert_eq!(
                    (shop.double.hits(), shop.double.sessions()),
                    (Vec::new(), 0),
                    "{arguments:?}: {:?}",
                    shop.double.requests()
                );
                let (holder, mode) =
                    shop.double.with(|c| (c.holder.clone(), c.value("MOD_Cube45", "tcMode")));
                assert_eq!((holder, mode.as_deref()), (Holder::Nobody, Some("-1")));
            }
        });
    }

    /// Half a millimetre between what is shown and what is calculated for the joints that are shown: another tool, another base, or a
    /// calibration. The answers would judge nothing.
    #[test]
    #[ignore = "long"]
    fn a_controller_that_contradicts_its_own_display_gives_no_conclusion() {
        on_each_robotware(|personality| {
            let planted = Planted { display_shift_m: [0.000_3, 0.0, -0.000_4], ..Planted::default() };
            let (asked, shop) = (double(personality), Shop::new(personality));
            asked.plant(planted);
            shop.double.plant(planted);
            let checked = check(&asked, &PROGRAMS[0]);
            assert_eq!(checked.agrees(), None);
            let LinkChecked::NoConclusion { apart_mm } = checked else { panic!("{}", checked.text(false)) };
            assert!((apart_mm - 0.5).abs() < 0.001, "{apart_mm} mm, planted 0.5");
            let (code, message, _) = shop.run(&["check", "MODULE", "HOST", "--json", "-"]);
            let json: serde_json::Value = serde_json::from_str(&message).unwrap();
            assert_eq!((code, &json["verdict"]), (2, &serde_json::Value::from("no_conclusion")), "{message}");
            assert!((json["display_mm"].as_f64().unwrap() - 0.5).abs() < 0.001, "{message}");
        });
    }
}
