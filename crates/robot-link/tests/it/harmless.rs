//! Nothing that the client can send could start, stop, jog, move the program pointer, switch motors, change a configuration or
//! restart; and the double sees it if it were sent.

use crate::bench::double;
use robot_link::Dialect;
use robot_link::requests::{ALL, Effect};
use rws_double::Personality;
use rws_double::tripwire::{RequestParts, judge};

/// Words of addresses, actions and fields that belong to motion, motors, pointer, configuration and restart.
const WORDS: [&str; 46] = [
    "start",
    "stop",
    "resetpp",
    "cycle",
    "holdtorun",
    "prodentry",
    "ctrlstate=",
    "setctrlstate",
    "motoron",
    "motoroff",
    "speedratio",
    "emergency",
    "opmode=",
    "acknowledge",
    "lock",
    "enable-switch",
    "collision",
    "restart",
    "backup",
    "restore",
    "compress",
    "clock",
    "jog",
    "set-mechunit",
    "position-target",
    "positiontarget",
    "moveinauto",
    "lead-through",
    "calib",
    "revcounter",
    "baseframe",
    "commutate",
    "pcp",
    "activate",
    "serviceroutine",
    "breakpoint",
    "abort",
    "set-text",
    "modify-position",
    "iosystem",
    "/cfg",
    "impersonate",
    "request-with-id",
    "watchdog",
    "mastership/motion",
    "allowmotioncontrol",
];

fn personality(dialect: Dialect) -> Personality {
    match dialect {
        Dialect::Rw6 => Personality::Rw6,
        Dialect::Rw7 => Personality::Rw7,
        Dialect::Rw8 => Personality::Rw8,
    }
}

fn pairs(text: &str) -> Vec<(String, String)> {
    let pairs = text.split('&').filter(|p| !p.is_empty());
    pairs.map(|p| p.split_once('=').unwrap_or((p, ""))).map(|(n, v)| (n.to_owned(), v.to_owned())).collect()
}

fn filled(form: &str) -> String {
    let names = [("home", "$HOME"), ("file", "Part.mod"), ("resources", "resources=1&1=x&1-p=1")];
    let form =
        names.iter().fold(form.to_owned(), |form, (name, value)| form.replace(&format!("{{{name}}}"), value));
    form.replace(['{', '}'], "")
}

#[test]
fn the_table_of_requests_holds_none_that_could_move_or_change_the_robot() {
    let mut checked = 0;
    for request in ALL {
        for dialect in Dialect::ALL {
            let Some(form) = request.form(dialect) else { continue };
            let form = filled(form);
            let mut words = form.splitn(3, ' ');
            let (method, uri, fields) =
                (words.next().unwrap(), words.next().unwrap(), words.next().unwrap_or_default());
            let (path, query) = uri.split_once('?').unwrap_or((uri, ""));
            let (query, form_fields) = (pairs(query), pairs(fields));
            let asked = RequestParts { method, path, query: &query, form: &form_fields };
            judge(personality(dialect), &asked)
                .unwrap_or_else(|hit| panic!("{} in {dialect}: {hit}", request.name));
            if method == "POST" {
                let lower = form.to_ascii_lowercase();
                let found: Vec<_> = WORDS.iter().filter(|word| lower.contains(*word)).collect();
                assert!(found.is_empty(), "{} in {dialect}: {found:?} in {form}", request.name);
            }
            assert!(method != "DELETE" || path.starts_with("/subscription/"), "{form}");
            assert!(method != "PUT" || request.effect == Effect::WritesFile, "{form}");
            checked += 1;
        }
    }
    assert!(checked > 80, "{checked}");
    let writes = ALL.iter().filter(|r| {
        matches!(r.effect, Effect::WritesData | Effect::WritesFile | Effect::Loads | Effect::Unloads)
    });
    assert_eq!(writes.count(), 4, "a value, a file, load and unload: no other write");
}

/// Requests are made in one place, from the table.
#[test]
fn no_other_code_makes_requests() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut places = Vec::new();
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let text = std::fs::read_to_string(&path).unwrap();
        let text = text.split("#[cfg(test)]").next().unwrap();
        for what in ["Request::builder()", "agent.run(", "wire::exchange(", "TcpStream::connect"] {
            let name = path.file_name().unwrap().to_string_lossy().into_owned();
            places.extend((0..text.matches(what).count()).map(|_| format!("{what} in {name}")));
        }
    }
    places.sort();
    assert_eq!(
        places,
        [
            "Request::builder() in session.rs",
            "TcpStream::connect in subscription.rs",
            "agent.run( in wire.rs",
            "agent.run( in wire.rs",
            "wire::exchange( in session.rs",
        ]
    );
}

/// Forms that move, stop, change or restart, as the manuals have them; each must be a hit.
const HARMFUL: [&str; 58] = [
    "6 POST /rw/rapid/execution?action=start",
    "6 POST /rw/rapid/execution?action=stop",
    "6 POST /rw/rapid/execution?action=resetpp",
    "6 POST /rw/rapid/execution?action=setcycle",
    "7 POST /rw/rapid/execution/start",
    "7 POST /rw/rapid/execution/stop",
    "7 POST /rw/rapid/execution/resetpp",
    "7 POST /rw/rapid/execution/startprodentry",
    "7 POST /rw/rapid/execution/cycle",
    "7 POST /rw/rapid/execution/holdtorun-state",
    "6 POST /rw/panel/ctrlstate?action=setctrlstate",
    "7 POST /rw/panel/ctrl-state",
    "7 POST /rw/panel/keyless-motoron",
    "7 POST /rw/panel/opmode",
    "6 POST /rw/panel/opmode?action=acknowledge",
    "7 POST /rw/panel/speedratio",
    "6 POST /rw/panel?action=restart",
    "7 POST /ctrl/restart",
    "6 POST /ctrl?action=restart",
    "7 POST /ctrl/backup/create",
    "7 POST /ctrl/backup/restore",
    "7 POST /ctrl/clock",
    "6 POST /rw/motionsystem?action=jog",
    "7 POST /rw/motionsystem/jog",
    "7 POST /rw/motionsystem/position-target",
    "6 POST /rw/motionsystem?action=set-target",
    "6 POST /rw/motionsystem/mechunits/ROB_1?action=set",
    "6 POST /rw/motionsystem/mechunits/ROB_1?action=fine-calibrate",
    "7 POST /rw/motionsystem/mechunits/ROB_1/lead-through",
    "7 POST /rw/motionsystem/mechunits/ROB_1/baseframe",
    "7 POST /rw/motionsystem/mechunits/ROB_1/smbdata",
    "6 POST /rw/rapid/tasks/T_ROB1/pcp?action=set-pp-routine",
    "7 POST /rw/rapid/tasks/T_ROB1/pcp/cursor",
    "7 POST /rw/rapid/tasks/T_ROB1/pcp/routine",
    "6 POST /rw/rapid/tasks/T_ROB1?action=activate",
    "7 POST /rw/rapid/tasks/T_ROB1/deactivate",
    "7 POST /rw/rapid/tasks/T_ROB1/program/load",
    "7 POST /rw/rapid/tasks/T_ROB1/program/save",
    "7 POST /rw/rapid/tasks/T_ROB1/serviceroutine",
    "7 POST /rw/rapid/tasks/T_ROB1/modules/Part/text",
    "6 POST /rw/rapid/modules/Part?action=set-text",
    "7 POST /rw/rapid/uiinstr/active/param",
    "6 POST /rw/iosystem/signals/doGrip?action=set",
    "7 POST /rw/iosystem/signals/doGrip/set-value",
    "6 POST /rw/cfg/moc?action=load",
    "7 DELETE /rw/cfg/moc/ARM/instances/rob1_1",
    "7 POST /rw/elog/clear",
    "7 POST /rw/mastership/motion/request",
    "6 POST /rw/mastership?action=request",
    "7 POST /rw/mastership/edit/request-with-id",
    "8 POST /rw/controlstation/allowmotioncontrol",
    "8 POST /rw/controlstation/register/local",
    "6 POST /users/rmmp privilege=exec",
    "7 POST /users/rmmp privilege=exec",
    "6 DELETE /fileservice/$HOME/Part.mod",
    "7 PUT /fileservice/HOME/../INTERNAL/syspar.cfg",
    "6 PUT /fileservice/$HOME/syspar.cfg",
    "7 POST /rw/rapid/tasks/T_ROB1/loadmod modulepath=HOME/Part.mod&replace=true",
];

#[test]
fn every_harmful_request_is_a_hit() {
    for form in HARMFUL {
        let mut words = form.splitn(4, ' ');
        let personality = match words.next().unwrap() {
            "6" => Personality::Rw6,
            "7" => Personality::Rw7,
            _ => Personality::Rw8,
        };
        let (method, uri, fields) =
            (words.next().unwrap(), words.next().unwrap(), words.next().unwrap_or_default());
        let (path, query) = uri.split_once('?').unwrap_or((uri, ""));
        let (query, form_fields) = (pairs(query), pairs(fields));
        assert!(
            judge(personality, &RequestParts { method, path, query: &query, form: &form_fields }).is_err(),
            "{form}"
        );
    }
}

/// What the double does with one that is really sent, by a client that is none of ours.
#[test]
fn a_harmful_request_that_is_sent_is_refused_and_counted() {
    use std::io::{Read, Write};
    let double = double(Personality::Rw6);
    let address = double.root().replace("http://", "");
    let mut line = std::net::TcpStream::connect(address).unwrap();
    line.write_all(b"POST /rw/rapid/execution?action=start HTTP/1.1\r\nContent-Length: 0\r\n\r\n").unwrap();
    let mut answer = [0; 12];
    line.read_exact(&mut answer).unwrap();
    assert_eq!(&answer, b"HTTP/1.1 403");
    assert_eq!(double.hits().len(), 1, "{:?}", double.hits());
}
