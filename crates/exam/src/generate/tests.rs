use super::*;
use crate::gaps::Gaps;
use crate::harmonics::Harmonics;
use crate::poses::Recorded;
use crate::registration::rms_after_registration_m;
use crate::row_fault::RowFault;
use crate::truth::QuestionKind;
use nalgebra::{Isometry3, Point3, Quaternion, UnitQuaternion};
use robot_model::robot::Joints;

fn recipe(effect: Effect, rho: f64) -> Recipe {
    Recipe {
        repeats: 10,
        recorded: Recorded { temperature: true, orientation: true, ..Recorded::NOTED },
        ..Recipe::plain("one", QuestionKind::One, vec![RequestedEffect { effect, rho }], 60)
    }
}

#[test]
fn the_effect_is_as_large_as_asked_and_the_oracle_is_left_with_the_noise() {
    let robot = SerialArm::built_in("irb140").unwrap();
    for seed in 0..5 {
        let wanted = 3.0;
        let recipe = recipe(Effect::JointCompliance { joint: 2 }, wanted);
        let set = data_set(&robot, "irb140", &recipe, &mut Rng::new(seed, 0)).unwrap();
        assert!((set.truth.effects[0].rho - wanted).abs() < 0.01, "{:?}", set.truth.effects);
        let noise_mm = 0.02 * 3.0_f64.sqrt();
        // rms of 180 numbers: a relative standard error of 1/sqrt(2*171) = 5.4 %; four of them
        assert!((set.truth.oracle_rms_mm / noise_mm - 1.0).abs() < 0.22, "{}", set.truth.oracle_rms_mm);
        let whole = (wanted * wanted + 1.0).sqrt() * noise_mm;
        assert!((set.truth.before_rms_mm / whole - 1.0).abs() < 0.15, "{}", set.truth.before_rms_mm);
        // Noise over all, as everywhere: an effect of the same rms at other poses drawn alike.
        let elsewhere = set.truth.oracle_ratio_elsewhere.unwrap() * (wanted * wanted + 1.0).sqrt();
        assert!((elsewhere - 1.0).abs() < 0.2, "{elsewhere}");
    }
}

#[test]
fn an_offset_of_joint_1_leaves_no_signal() {
    let robot = SerialArm::built_in("irb140").unwrap();
    let recipe = recipe(Effect::JointOffset { joint: 1 }, 2.0);
    assert!(data_set(&robot, "irb140", &recipe, &mut Rng::new(3, 0)).is_none());
}

#[test]
fn every_row_has_every_column_and_the_same_seed_the_same_bytes() {
    let robot = SerialArm::built_in("irb140").unwrap();
    let make = || {
        let recipe =
            recipe(Effect::GearMesh { joint: 2, n: 20, phase_rad: 0.3, harmonics: Harmonics::NONE }, 1.0);
        data_set(&robot, "irb140", &recipe, &mut Rng::new(11, 2)).unwrap().csv
    };
    let csv = make();
    assert_eq!(csv, make());
    let columns = csv.lines().next().unwrap().split(',').count();
    assert_eq!(columns, 2 + 1 + 6 + 3 + 4 + 6 + 1 + 7);
    assert!(csv.lines().all(|line| line.split(',').count() == columns));
    assert_eq!(csv.lines().count(), 61);
}

/// The names of a file's columns, and its cells row by row.
fn table(csv: &str) -> (Vec<String>, Vec<Vec<String>>) {
    let split = |line: &str| line.split(',').map(str::to_owned).collect();
    let mut lines = csv.lines();
    (split(lines.next().unwrap()), lines.map(split).collect())
}

/// The numbers in the named columns, row by row.
fn numbers<const N: usize>(csv: &str, names: [&str; N]) -> Vec<[f64; N]> {
    let (header, rows) = table(csv);
    let at = names.map(|name| header.iter().position(|h| h == name).unwrap());
    rows.iter().map(|row| at.map(|c| row[c].parse().unwrap())).collect()
}

/// The nests' plane turns by the tilt alone: by its amplitude times the difference of the moments over the foot, of an arm that is
/// stretched forward and one that is stretched backward; and the three keep their distances.
#[test]
fn nests_on_the_base_turn_by_its_tilt() {
    let robot = SerialArm::built_in("irb140").unwrap();
    let recipe = Recipe { sigma_mm: 0.002, ..recipe(Effect::BaseTilt, 30.0) };
    let sides = [0.0_f64, 175.0].map(f64::to_radians);
    let stretched = |q1: f64| Joints::from_fn(6, |j| [q1, 1.0, -0.6, 0.0, 0.4, 0.0][j]);
    let rows: Vec<CommandedRow> = (0..20)
        .map(|pose| CommandedRow {
            pose,
            q_rad: stretched(sides[pose % 2]),
            direction: Joints::from_fn(6, |_| 1),
            payload_kg: 0.0,
        })
        .collect();
    let more = MoreRows { rows: &rows, from_cold: false, seed: 5, with_nests: true };
    let set = continued_set(&robot, "irb140", &recipe, more, &mut Rng::new(11, 2)).unwrap();
    let (header, cells) = table(&set.csv);
    assert!(cells.iter().all(|row| row.len() == header.len()));
    let column = |name: &str| header.iter().position(|h| h == name).unwrap();
    let points = numbers(&set.csv, ["x_mm", "y_mm", "z_mm"]);
    let nests: Vec<Vector3<f64>> = cells
        .iter()
        .zip(&points)
        .filter(|(row, _)| row[column("kind")] == "base")
        .map(|(_, point)| Vector3::from(*point))
        .collect();
    assert_eq!(nests.len(), 3 * rows.len());
    let mut normals = [Vector3::zeros(); 2];
    for (k, three) in nests.chunks_exact(3).enumerate() {
        let [a, b] = [three[1] - three[0], three[2] - three[0]];
        // Of places written down beside the foot: (-0.44, 0.22, 0.02) and (-0.53, -0.40, 0.04) m.
        assert!(
            (a.norm() - 492.341).abs() < 0.02 && (b.norm() - 665.207).abs() < 0.02,
            "{} {}",
            a.norm(),
            b.norm()
        );
        normals[k % 2] += a.cross(&b).normalize() / 10.0;
    }
    let arm = ScrewArm::new(&robot);
    let moments = sides.map(|q1| arm.moment_n_m(0, &stretched(q1), 0.0, &Point3::origin()).xy());
    let expected_rad = set.truth.effects[0].amplitude * (moments[0] - moments[1]).norm();
    let turned_rad = normals[0].cross(&normals[1]).norm();
    assert!((turned_rad / expected_rad - 1.0).abs() < 0.05, "{turned_rad} {expected_rad}");
}

/// What a small effect adds to the file, base and target fitted by the orientations that stand in it.
#[test]
fn a_small_effect_adds_its_share_of_the_noise_to_the_file_and_stands_apart_in_the_truth() {
    let robot = SerialArm::built_in("irb140").unwrap();
    let gear = Effect::GearMesh { joint: 2, n: 20, phase_rad: 0.3, harmonics: Harmonics::NONE };
    let plain = recipe(gear, 2.0);
    let made = |recipe: &Recipe| data_set(&robot, "irb140", recipe, &mut Rng::new(4, 0)).unwrap();
    let without = made(&plain);
    for (effect, rho) in [
        (Effect::JointOffset { joint: 3 }, 0.05),
        (Effect::BaseTilt, 0.1),
        (Effect::JointGain { joint: 2 }, 0.25),
    ] {
        let with = made(&Recipe { small: vec![RequestedEffect { effect, rho }], ..plain.clone() });
        assert_eq!(with.truth.effects, without.truth.effects);
        assert_eq!((with.truth.small.len(), with.truth.small[0].effect), (1, effect));
        let points = |set: &DataSet| {
            let rows = numbers(&set.csv, ["x_mm", "y_mm", "z_mm"]);
            rows.into_iter().map(|mm| Vector3::from(mm).map(m_from_mm)).collect::<Vec<_>>()
        };
        let (here, there) = (points(&without), points(&with));
        let off_m: Vec<Vector3<f64>> = there.iter().zip(&here).map(|(a, b)| a - b).collect();
        let flanges: Vec<Isometry3<f64>> = numbers(&without.csv, ["qw", "qx", "qy", "qz"])
            .into_iter()
            .map(|[w, x, y, z]| UnitQuaternion::from_quaternion(Quaternion::new(w, x, y, z)))
            .map(|turn| Isometry3::from_parts(Vector3::zeros().into(), turn))
            .collect();
        let rms_mm = mm_from_m(rms_after_registration_m(&flanges, &here, &off_m));
        let noise_mm = 0.02 * 3.0_f64.sqrt();
        // Four decimals of a millimetre, each wrong by 0.00003 mm rms: 0.00005 mm of the 0.0017 mm that are asked at least.
        assert!((rms_mm / noise_mm / rho - 1.0).abs() < 0.05, "{effect:?}: {}", rms_mm / noise_mm);
        assert!((with.truth.small[0].rho / rho - 1.0).abs() < 0.01);
    }
}

#[test]
fn slow_noise_is_like_its_row_before_and_as_large_as_white_noise() {
    const ROWS: usize = 3000;
    for slowness in [0.0_f64, 0.6, 0.8] {
        let recipe = Recipe { n: ROWS, slowness, ..recipe(Effect::BaseTilt, 1.0) };
        let noise_m = RowNoise::draw(&recipe, &mut Rng::new(6, 0)).added_to(vec![Vector3::zeros(); ROWS]);
        let sum = |lag: usize| noise_m.iter().zip(&noise_m[lag..]).map(|(a, b)| a.dot(b)).sum::<f64>();
        let numbers = 3.0 * ROWS as f64;
        // Bartlett 1946, first order: var r1 = (1 - a^2) / N, var s^2 = 2 / N (1 + a^2) / (1 - a^2); four of each.
        let square = slowness * slowness;
        let correlation = sum(1) / sum(0);
        let within = 4.0 * ((1.0 - square) / numbers).sqrt();
        assert!((correlation - slowness).abs() < within, "{slowness}: {correlation}");
        let variance = sum(0) / numbers / m_from_mm(0.02).powi(2);
        let within = 4.0 * (2.0 / numbers * (1.0 + square) / (1.0 - square)).sqrt();
        assert!((variance - 1.0).abs() < within, "{slowness}: {variance}");
    }
}

/// The first row of a fault of rows: four tenths of sixty.
const FROM: usize = 24;
/// The beam is lost for an eighth of sixty rows.
const LOST: usize = 7;

/// The number that the fault puts into row `k` of the column in place of the sound file's, by hand; `None`: it stays.
fn falsified(fault: RowFault, k: usize, column: &str, sound: &dyn Fn(usize) -> f64) -> Option<f64> {
    let point = ["x_mm", "y_mm", "z_mm"].contains(&column);
    let from_here_on = point && k >= FROM;
    match fault {
        RowFault::Metres => from_here_on.then(|| sound(k) / 1e3),
        RowFault::RowsInInches => from_here_on.then(|| sound(k) / 25.4),
        RowFault::Frozen => (from_here_on && k < FROM + LOST).then(|| sound(FROM)),
        RowFault::OneLate => (point && k > FROM).then(|| sound(k - 1)),
        RowFault::OneEarly => from_here_on.then(|| sound(k + 1)),
        RowFault::Inches => (column == "x_mm").then(|| sound(k) / 25.4),
        RowFault::Radians => (column == "q3_deg").then(|| sound(k) * std::f64::consts::PI / 180.0),
        RowFault::FineRounding => column.ends_with("_deg").then(|| 0.05 * (sound(k) / 0.05).round()),
        RowFault::Grams => (column == "payload_kg").then(|| 1000.0 * sound(k)),
        RowFault::Fahrenheit => column.starts_with("temp_").then(|| 9.0 / 5.0 * sound(k) + 32.0),
        RowFault::OnePose => (column == "pose_id").then_some(0.0),
    }
}

#[test]
fn every_fault_shows_in_its_own_cells_and_in_no_others() {
    let robot = SerialArm::built_in("irb140").unwrap();
    let plain = recipe(Effect::BaseTilt, 1.0);
    let made = |effects: Vec<Effect>| {
        let effects = effects.into_iter().map(|effect| RequestedEffect { effect, rho: 1.0 }).collect();
        data_set(&robot, "irb140", &Recipe { effects, ..plain.clone() }, &mut Rng::new(8, 0)).unwrap().csv
    };
    let (names, sound) = table(&made(Vec::new()));
    for fault in RowFault::ALL {
        let (_, found) = table(&made(vec![Effect::RowFault { fault, from: 0.4 }]));
        let mut changed = 0;
        for (c, name) in names.iter().enumerate() {
            let number = |k: usize| sound.get(k).map_or(f64::NAN, |row| row[c].parse().unwrap());
            for (k, row) in found.iter().enumerate() {
                let Some(expected) = falsified(fault, k, name, &number) else {
                    assert_eq!(row[c], sound[k][c], "{fault:?}, {name}, row {k}");
                    continue;
                };
                // One point was not taken, so the last row has none.
                if expected.is_nan() {
                    assert_eq!((row[c].as_str(), k), ("", 59), "{fault:?}, {name}");
                    continue;
                }
                let digits = row[c].split('.').nth(1).map_or(0, str::len);
                // Both files are rounded, each to half of its last digit; the larger number's counts for as much as it is scaled.
                let off = (row[c].parse::<f64>().unwrap() - expected).abs();
                assert!(off < 1.5 * 10_f64.powi(-(digits as i32)), "{fault:?}, {name}, row {k}: {}", row[c]);
                changed += usize::from(row[c] != sound[k][c]);
            }
        }
        assert!(changed >= LOST * 3 - 3, "{fault:?}: {changed} cells");
    }
}

#[test]
fn gaps_stand_in_their_column_in_as_many_rows_as_asked() {
    let robot = SerialArm::built_in("irb140").unwrap();
    let plain = recipe(Effect::BaseTilt, 1.0);
    let made = |recipe: &Recipe| data_set(&robot, "irb140", recipe, &mut Rng::new(8, 0)).unwrap();
    let (names, sound) = table(&made(&plain).csv);
    for (column, as_nan, text) in [("q3_deg", true, "NaN"), ("z_mm", false, "")] {
        let gaps = Gaps { column: column.to_owned(), share: 0.1, as_nan, seed: 3 };
        let set = made(&Recipe { gaps: Some(gaps.clone()), ..plain.clone() });
        assert_eq!(set.truth.gaps, Some(gaps));
        let changed: Vec<(&str, String)> = table(&set.csv)
            .1
            .into_iter()
            .zip(&sound)
            .flat_map(|(row, sound)| {
                row.into_iter()
                    .zip(sound)
                    .zip(&names)
                    .filter(|((a, b), _)| a != *b)
                    .map(|((a, _), name)| (name.as_str(), a))
                    .collect::<Vec<_>>()
            })
            .collect();
        assert_eq!(changed, vec![(column, text.to_owned()); 6]);
    }
}
