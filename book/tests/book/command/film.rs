//! `scene --film` and `--frames`: what moves, where the closed form has it.

use super::*;

/// A ball with a weight, free of gravity: its axis goes round L at the rate L/I₁.
const FREE: &str = "[body]\nshape = \"ball-with-weight\"\nmass = 2.0\nradius = 1.0\nweight = 0.25\n\
     weight_at = [0.0, 0.0, 0.8]\n[initial]\nomega = [1.0, 0.0, 3.0]\n[run]\nuntil = 7.0\nsamples = 2\n";

#[test]
fn a_film_shows_the_axis_where_the_closed_form_has_it() {
    let (folder, scene) = mine(FREE);
    let film = folder.path().join("free.svg");
    let out = ["--output", film.to_str().unwrap()];
    let arguments = [&["--film", "--speed", "0.7"][..], &out].concat();
    printed(&super::scene(&scene, &arguments));
    let svg = std::fs::read_to_string(&film).unwrap();
    assert!(svg.contains("prefers-reduced-motion") && svg.contains("prefers-color-scheme"));
    assert!(svg.contains("0.7 × real time"));
    let frames: Vec<&str> = svg.split("<g class=\"fig-film").skip(1).collect();
    assert!(frames.len() > 100 && svg.matches("<g ").count() == svg.matches("</g>").count());
    // From the centre of the ball to the weight, on the paper, right and down.
    let bar = |frame: &str| {
        let line = frame.split("stroke-width=\"20\" points=\"").nth(1).unwrap();
        let ends = line.split('"').next().unwrap().split([' ', ',']);
        let ends: Vec<f64> = ends.map(|number| number.parse().unwrap()).collect();
        [ends[2] - ends[0], ends[3] - ends[1]]
    };
    let spin = 0.4 * 0.75 * 2.0;
    let across = spin + 2.0 * 0.25 * 0.75 * 0.64;
    let l = nalgebra::Vector3::new(across, 0.0, 3.0 * spin);
    // Seen from 1.2 rad before the x axis and 0.3 rad above.
    let (se, ce) = 0.3_f64.sin_cos();
    let (sa, ca) = (-1.2_f64).sin_cos();
    let right = nalgebra::Vector3::new(-sa, ca, 0.0);
    let up = nalgebra::Vector3::new(-se * ca, -se * sa, ce);
    let length = -bar(frames[0])[1] / ce;
    let mut farthest = 0.0_f64;
    for (k, frame) in frames.iter().enumerate() {
        let t = 7.0 * k as f64 / (frames.len() - 1) as f64;
        let turn = nalgebra::UnitQuaternion::from_scaled_axis(l * (t / across));
        let axis = turn * nalgebra::Vector3::z() * length;
        let [x, y] = bar(frame);
        farthest = farthest.max((x - right.dot(&axis)).hypot(y + up.dot(&axis)));
    }
    // Four ends rounded to whole units.
    assert!(farthest > 0.1 && farthest < 2.5, "{farthest}");
}

/// Of the scenes of the book the first, third, … or the second, fourth, …
fn are_filmed(first: usize) {
    let scenes = press::paths::files_below(Path::new("scenes")).unwrap();
    assert!(scenes.len() >= 24, "{}", scenes.len());
    for path in scenes.iter().skip(first).step_by(2) {
        let svg = printed(&super::scene(path, &["--film"]));
        assert!(svg.len() < 400_000 && svg.ends_with("</svg>\n"), "{path:?}");
        // What is no number is drawn far outside.
        let lost = svg.contains("NaN") || svg.contains("2147483648");
        assert!(!lost, "{path:?}");
    }
}

#[test]
fn every_other_scene_of_the_book_is_filmed() {
    are_filmed(0);
}

#[test]
fn the_scenes_between_them_are_filmed() {
    are_filmed(1);
}

#[test]
fn what_is_no_film_is_refused() {
    for (wrong, told) in [
        ("--film --speed=-1", "expected a speed from"),
        ("--film --speed 1e3", "a speed from 1.667e-1 to 1.000e1"),
        ("--speed 1", "--film"),
        ("--speed 1 --plot tilt", "--speed"),
        ("--film --as png", "--as"),
        ("--plot tlit", "did you mean `tilt`?"),
        ("--plot x:x", "has no column `x`"),
        ("--film --plot tilt", "cannot be used with"),
        ("--film --speed 0", "expected a speed from"),
        ("--film --output x.png", "must end with `.svg`"),
        ("--frames src 10", "expected an empty folder or a new one"),
        ("--frames - 10", "expected an empty folder or a new one"),
        ("--frames stills 0", "a whole number from 1 to 10000"),
    ] {
        refused(&typed(&format!("scene racket {wrong}")), &[told]);
    }
    // A single time is no motion.
    let (_folder, scene) = mine(&FREE.replace("until = 7.0\nsamples = 2", "times = [1.0, 1.0]"));
    for options in [
        &["--film"][..],
        &["--plot", "tilt"],
        &["--frames", "stills", "2"],
    ] {
        let done = super::scene(&scene, options);
        let keys = "mine.toml:10: key `times`, `until` in [run]: ";
        let told = format!("{keys}{}: expected more than one time", options[0]);
        refused(&done, &[&told]);
    }
}

#[test]
fn stills_are_whole_and_numbered() {
    let folder = scratch();
    let stills = folder.path().join("stills");
    let wanted = ["scene", "spool", "--frames", stills.to_str().unwrap(), "12"];
    printed(&book(&wanted));
    assert!((1..=12).map(|k| format!("{k:02}.svg")).eq(names(&stills)));
    let last = std::fs::read_to_string(stills.join("12.svg")).unwrap();
    assert!(last.contains(">1.00 s<") && last.ends_with("</svg>\n"));
    // There are stills already.
    assert_eq!(book(&wanted).status.code(), Some(2));
}
