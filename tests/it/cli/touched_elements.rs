//! What an element of an array means that was touched up with ModPos, of drifts of several shapes.

use super::changed_by_hand::{module, restored};
use super::{Bench, driftpost, err};

/// Joint 2 stands off from the cold start on, joint 3 warms up: the corrections of two minutes are not in proportion.
const OFFSET_AND_DRIFT: &str = "format = 1\nrobot = \"ABB IRB 140-6/0.8\"\n\
    [[effect]]\neffect = \"joint_offset\"\njoint = 2\noffset_deg = 0.03\n\
    [[effect]]\neffect = \"thermal_joint_drift\"\njoint = 3\ngrowth = \"exp\"\ntau_min = 40\ndrift_deg = 0.03\n";
/// Two joints that warm up at rates of their own.
const TWO_LAWS: &str = "format = 1\nrobot = \"ABB IRB 140-6/0.8\"\n\
    [[effect]]\neffect = \"thermal_joint_drift\"\njoint = 2\ngrowth = \"exp\"\ntau_min = 10\ndrift_deg = 0.02\n\
    [[effect]]\neffect = \"thermal_joint_drift\"\njoint = 3\ngrowth = \"exp\"\ntau_min = 120\ndrift_deg = -0.04\n";

fn source() -> String {
    module("CONST robtarget p20:=[[430,60,300],@;", "MoveL p20,v100,fine,tGun;")
}

/// The source in form `schedule` for a model, and the lines of the elements of p20's array.
fn scheduled(bench: &Bench, model: &str, options: &[&str]) -> (String, Vec<usize>) {
    let (from, to) = (bench.file("a.mod", source()), bench.path("o.mod").display().to_string());
    let model = bench.file("model.toml", model);
    let given = ["compensate", &from, "-o", &to, "--model", &model, "--diff", "none", "--force"];
    let made = driftpost(&[&given, options].concat());
    assert_eq!(made.status.code(), Some(0), "{}", err(&made));
    let text = bench.text("o.mod");
    let declared = text.lines().position(|line| line.contains("robtarget tcp20{")).unwrap();
    let count: usize = text.lines().nth(declared).unwrap().split(['{', '}']).nth(1).unwrap().parse().unwrap();
    (text, (1..=count).map(|k| declared + k).collect())
}

/// The text with the target on a line moved along x.
fn moved(text: &str, line: usize, by_mm: f64) -> String {
    let with = |(i, row): (usize, &str)| {
        let (before, rest) = row.split_once("[[").filter(|_| i == line)?;
        let (x, rest) = rest.split_once(',')?;
        Some(format!("{before}[[{:.5},{rest}", x.parse::<f64>().unwrap() + by_mm))
    };
    let lines = text.lines().enumerate().map(|(i, row)| with((i, row)).unwrap_or_else(|| row.to_owned()));
    lines.map(|line| line + "\n").collect()
}

/// The declared position of p20, mm.
fn position(text: &str) -> [f64; 3] {
    let value = text.split_once("robtarget p20:=[[").unwrap().1.split(']').next().unwrap();
    let numbers: Vec<f64> = value.split(',').map(|number| number.parse().unwrap()).collect();
    numbers.try_into().unwrap()
}

/// Half a millimetre along x is half a millimetre of the original, whichever element the robot stood by: buckets lie as near to each other as the tolerance
/// of 0.005 mm asks, and what was an element's own correction lies between its neighbours' to a fifth of that.
#[test]
fn a_touched_up_element_means_the_original_by_as_much() {
    let bench = Bench::default();
    for model in [OFFSET_AND_DRIFT, TWO_LAWS] {
        let (text, elements) = scheduled(&bench, model, &[]);
        let last = elements.len() - 1;
        assert!(last > 8);
        for k in [0, 1, 2, last / 2, last - 1, last] {
            let (message, back) = restored(&bench, &moved(&text, elements[k], 0.5), 1);
            let [x, y, z] = position(&back);
            let off = [x - 430.5, y - 60.0, z - 300.0].map(f64::abs).into_iter().fold(0.0, f64::max);
            assert!(off < 0.001, "element {}: {x} {y} {z}", k + 1);
            assert!(message.contains("p20 was touched up on the controller by "), "{message}");
        }
        // Two that mean the same, one at the beginning and one in the middle.
        let both = moved(&moved(&text, elements[2], 0.5), elements[last / 2], 0.5);
        let (_, back) = restored(&bench, &both, 1);
        assert!((position(&back)[0] - 430.5).abs() < 0.001, "{back}");
    }
}

/// A model without a drift has one bucket, and nothing beside an element that was touched up says how it was corrected, but what the comment block
/// holds: 0.5 mm are 0.5 mm to the controller's digits, of either element; of the original that is where it stands now.
#[test]
fn the_only_corrected_element_means_the_original_by_as_much() {
    let bench = Bench::default();
    let cold = OFFSET_AND_DRIFT.split("[[effect]]\neffect = \"thermal").next().unwrap();
    let (text, elements) = scheduled(&bench, cold, &[]);
    assert_eq!(elements.len(), 2);
    let (_, same) = restored(&bench, &text, 0);
    assert_eq!(same, source());
    for k in [0, 1] {
        let (message, back) = restored(&bench, &moved(&text, elements[k], 0.5), 1);
        let [x, y, z] = position(&back);
        let off = [x - 430.5, y - 60.0, z - 300.0].map(f64::abs).into_iter().fold(0.0, f64::max);
        assert!(
            off < 1e-4 && message.contains("p20 was touched up on the controller by 0.5000 mm"),
            "{x} {y} {z} {message}"
        );
    }
    // Both: nothing says any more what they were.
    let both = moved(&moved(&text, elements[0], 0.5), elements[1], 0.5);
    let (message, _) = restored(&bench, &both, 2);
    assert!(message.contains("what was changed of tcp20 cannot be told"), "{message}");
}
