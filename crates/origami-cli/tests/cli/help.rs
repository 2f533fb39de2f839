//! The help texts are golden files: a change of the command line shows up in review. To renew them set
//! `ORIGAMI_UPDATE_GOLDEN=1`.

use std::path::Path;

use assert_cmd::Command;

fn golden(name: &str, args: &[&str]) {
    let output = Command::cargo_bin("origami").unwrap().args(args).env("COLUMNS", "100").output().unwrap();
    assert!(output.status.success(), "{args:?} ends with {}", output.status);
    assert!(output.stderr.is_empty(), "help goes to standard output");
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(!text.contains('\u{1b}'), "no colours where no terminal is");
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden").join(format!("{name}.txt"));
    if std::env::var_os("ORIGAMI_UPDATE_GOLDEN").is_some() {
        std::fs::write(&path, &text).unwrap();
    }
    let expected = std::fs::read_to_string(&path).unwrap_or_default();
    assert_eq!(text, expected, "{} is out of date: ORIGAMI_UPDATE_GOLDEN=1 renews it", path.display());
    let longest = text.lines().map(|line| line.chars().count()).max().unwrap_or(0);
    assert!(longest <= 100, "a line of {longest} characters");
}

#[test]
fn help_is_as_reviewed() {
    golden("origami", &["--help"]);
    golden("adapters", &["adapters", "--help"]);
    golden("fold", &["fold", "--help"]);
    golden("fold-short", &["fold", "-h"]);
    golden("sweep", &["sweep", "--help"]);
    golden("sweep-short", &["sweep", "-h"]);
    golden("merge", &["merge", "--help"]);
    golden("render", &["render", "--help"]);
    golden("study", &["study", "--help"]);
    golden("analyse", &["analyse", "--help"]);
    golden("analyse-path", &["analyse", "path", "--help"]);
    golden("analyse-modes", &["analyse", "modes", "--help"]);
    golden("design", &["design", "--help"]);
    golden("info", &["info", "--help"]);
    golden("pattern", &["pattern", "--help"]);
    golden("view", &["view", "--help"]);
    golden("completions", &["completions", "--help"]);
    golden("man", &["man", "--help"]);
}

#[test]
fn every_command_shows_an_example() {
    let commands = [
        "fold",
        "sweep",
        "merge",
        "render",
        "study",
        "analyse",
        "design",
        "info",
        "pattern",
        "view",
        "adapters",
        "completions",
        "man",
    ];
    for command in commands {
        let output = Command::cargo_bin("origami").unwrap().args([command, "--help"]).output().unwrap();
        let text = String::from_utf8(output.stdout).unwrap();
        assert!(text.contains(&format!("  origami {command}")), "{command}: {text}");
    }
}

#[test]
fn completions_and_manual_page_name_every_command() {
    for args in [&["completions", "bash"][..], &["completions", "zsh"], &["completions", "fish"], &["man"]] {
        let output = Command::cargo_bin("origami").unwrap().args(args).output().unwrap();
        assert!(output.status.success(), "{args:?}");
        let text = String::from_utf8(output.stdout).unwrap();
        for word in [
            "fold",
            "sweep",
            "merge",
            "render",
            "study",
            "info",
            "pattern",
            "adapters",
            "completions",
            "percent",
            "tolerance",
        ] {
            assert!(text.contains(word), "{args:?} does not name {word}");
        }
    }
}

#[test]
fn version_is_that_of_the_package() {
    let output = Command::cargo_bin("origami").unwrap().arg("--version").output().unwrap();
    assert_eq!(String::from_utf8(output.stdout).unwrap(), format!("origami {}\n", env!("CARGO_PKG_VERSION")));
}
