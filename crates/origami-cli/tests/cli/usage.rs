//! What is refused before any work, and that nothing is written then.

use crate::place::Place;

#[test]
fn bad_usage_is_1_and_names_what_is_wrong() {
    let place = Place::new();
    let cases = [
        ("", "Usage: origami"),
        ("unfold", "unfold"),
        ("fold", "<INPUT>"),
        ("fold square.fold", "--output"),
        ("fold square.fold -o a.fold --percent", "--percent"),
        ("fold square.fold -o a.fold --percent nan", "expected a finite number"),
        ("fold square.fold -o a.fold --percent 1e999", "expected a finite number"),
        ("fold square.fold -o a.fold --tolerance 0", "greater than 0"),
        ("fold square.fold -o a.fold --ea 0", "greater than 0"),
        ("fold square.fold -o a.fold --k-face=-1", "at least 0"),
        ("fold square.fold -o a.fold --time-step soon", "`paper`, `safe` or a finite number"),
        ("fold square.fold -o a.fold --time-step -1", "`paper`, `safe` or a finite number"),
        ("fold square.fold -o a.fold --integrator leapfrog", "euler or verlet"),
        ("fold square.fold -o a.fold --solver magic", "relax, dynamics, newton or reflect"),
        ("fold square.fold -o a.fold --solver newton --residual 0", "greater than 0"),
        ("fold square.fold -o a.fold --steps -3", "-3"),
        ("fold square.fold -o a.fold --frames 0", "--frames 0: expected a whole number from 1 to 100000"),
        ("fold square.fold -o a.fold --threads 0", "--threads 0: expected a whole number of at least 1"),
        ("fold square.fold -o a.fold --backend tpu", "auto, cpu or gpu"),
        (
            "fold square.fold -o a.jpg",
            "a.jpg: the format .jpg is not known; expected .fold, .obj, .stl, .glb, .html, .png or",
        ),
        ("fold square.fold -o a", "a: no extension tells the format; expected .fold, .obj, .stl"),
        ("fold square.fold --png a.jpg", "a.jpg: expected a path ending in .png for --png"),
        ("fold square.fold -o a.png --size 0x3", "expected pixels across and down, such as 1000x800"),
        ("fold square.fold -o a.png --samples 3", "expected 1, 4, 8 or 16"),
        ("fold square.fold -o a.png --strain --map energy", "cannot be used with"),
        ("fold square.fold -o a.png --map heat", "strain, face-strain, angle-error or energy"),
        ("fold square.fold -o a.png --turntable 3", "--animate"),
        ("fold square.fold --animate a.gif", "nothing moves; expected --frames N, --turntable N, both or --sequence"),
        ("render square.fold", "--output"),
        ("render square.fold -o a.obj", "a.obj: expected a path ending in .png, .svg or .glb"),
        ("fold square.fold -o away/a.fold", "away/a.fold: there is no folder away"),
        ("fold square.fold -o a.fold -o a.fold", "a.fold is named twice"),
        ("fold square.fold -o a.fold -o ./a.fold", "a.fold is named twice"),
        ("fold square.fold -o ./", "./square.fold: would be replaced by what is made from it"),
        ("fold square.fold -o square.fold", "square.fold: would be replaced by what is made from it; expected another"),
        ("fold square.fold --sheet s.png --animate ./square.fold --frames 2", "no film is written as this"),
        ("fold square.fold -o a.fold --line-width 1000", "--line-width 1000: expected a number from 0.05 to 50"),
        ("fold squar.fold -o a.fold", "squar.fold: No such file or directory (os error 2); perhaps square.fold"),
        ("pattern miurra -o a.fold", "miurra: is not known, perhaps miura; expected "),
        (
            "pattern miura --set colums=6 -o a.fold",
            "expected one of columns, rows, a, b, gamma, theta; perhaps columns",
        ),
        ("pattern fan --set valence=16000000 -o a.fold", "parameter valence: is 16000000, too large a sheet"),
        ("fold square.fold -o a.fold --report ./a.fold", "expected different ones"),
        ("fold square.fold -o a.fold --perturbation 2", "a number from 0 to 1"),
        ("fold square.fold -o - -o -", "- is named twice"),
        ("fold square.fold -o - --report -", "expected different ones"),
        ("fold square.fold -o a.fold --report a.fold", "expected different ones"),
        ("fold square.fold -o a.fold --report square.fold", "would overwrite an input"),
        ("fold square.fold -o a.fold --report ./square.fold", "would overwrite an input"),
        ("fold square.fold -o a.fold --report away/r.json", "there is no folder away"),
        ("fold square.fold -o a.fold --format obj", "--format is for folders"),
        ("fold square.fold square.fold -o a.fold", "2 inputs cannot go into one file"),
        ("fold square.fold other.fold -o -", "2 inputs cannot go into one file"),
        ("fold square.fold ./square.fold -o out/", "would both be written as square"),
        ("fold - - --report r.json", "standard input (-) is named twice"),
        ("info", "<INPUT>"),
        ("pattern miura", "--output"),
        ("pattern miura --set columns -o a.fold", "expected KEY=VALUE"),
        ("pattern miura --set columns=many -o a.fold", "expected a finite number"),
        ("completions klingon", "klingon"),
    ];
    let draws = cfg!(feature = "render");
    for (words, expected) in cases.into_iter().filter(|(words, _)| draws || !words.contains("--sheet")) {
        let ran = place.run(words);
        ran.fails(1, expected);
        assert_eq!(ran.stdout, "", "{words}");
        assert_eq!(place.names(), ["square.fold"], "{words} leaves nothing behind");
    }
}

#[test]
fn options_without_effect_are_told() {
    let place = Place::new();
    let ran = place.run("fold square.fold -o a.fold --time-step safe --integrator verlet --zeta 0.1 --percent 120");
    assert_eq!(ran.code, 0);
    for expected in [
        "warning: --time-step has no effect with --solver relax",
        "warning: --integrator has no effect with --solver relax",
        "warning: --zeta has no effect with --solver relax",
        "warning: --percent 120: folds past the pattern's own angles",
    ] {
        assert!(ran.stderr.contains(expected), "{}", ran.stderr);
    }
    place.run("fold square.fold -o a.fold --zeta 0.1 --quiet").succeeds();
    place.run("fold square.fold -o a.fold --solver dynamics --zeta 0.1").succeeds();
    let ran = place.run("fold square.fold -o a.fold --solver dynamics --perturbation 0.1");
    assert_eq!(ran.stderr, "warning: --perturbation has no effect with --solver dynamics\n");
    let ran = place.run("fold square.fold -o a.fold --residual 1e-9");
    assert_eq!(ran.stderr, "warning: --residual has no effect with --solver relax\n");
    let ran = place.run("fold square.fold -o a.fold --backend cpu --adapter llvmpipe");
    assert_eq!(ran.stderr, "warning: --adapter has no effect with --backend cpu\n");
    let words = "fold square.fold -o a.fold --backend cpu".split(' ');
    let output = place.command().args(words).env("ORIGAMI_ADAPTER", "llvmpipe").output().unwrap();
    assert!(output.stderr.is_empty(), "what the environment names is not meant for this run alone");
}
