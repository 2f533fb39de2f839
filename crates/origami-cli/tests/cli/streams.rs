//! Standard input, output and error, and what happens where nobody is at their other end.

use std::io::Write;
use std::process::{Command, Stdio};

use serde_json::Value;

use crate::place::{Place, SQUARE};

#[test]
fn works_as_a_filter() {
    let place = Place::new();
    let ran = place.run_with("fold - -o -", SQUARE);
    assert_eq!(ran.code, 0);
    let folded: Value = serde_json::from_str(&ran.stdout).unwrap();
    assert!((folded["edges_foldAngle"][4].as_f64().unwrap() - 90.0).abs() < 1e-3);
    assert!(ran.stderr.starts_with("-: folded to 100 %"), "{}", ran.stderr);
    assert_eq!(place.run_with("fold - -o - --quiet", SQUARE).succeeds(), ran.stdout);
}

#[test]
fn standard_input_has_a_name_in_a_folder() {
    let place = Place::new();
    place.run_with("fold - square.fold -o out/", SQUARE).succeeds();
    assert_eq!(place.text("out/stdin.fold"), place.text("out/square.fold"));
}

#[test]
fn an_empty_standard_input_is_bad_input() {
    Place::new().run_with("fold - -o -", "").fails(1, "error: -: line 1: the file is empty");
}

/// The exit code and standard error of a run whose reader goes away before there is anything to read.
fn without_a_reader(args: &[&str]) -> (i32, String) {
    let mut command = Command::new(assert_cmd::cargo::cargo_bin!("origami"));
    command.args(args).stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().unwrap();
    drop(child.stdout.take());
    child.stdin.take().unwrap().write_all(SQUARE.as_bytes()).unwrap();
    let output = child.wait_with_output().unwrap();
    (output.status.code().unwrap(), String::from_utf8(output.stderr).unwrap())
}

#[test]
fn a_broken_pipe_ends_silently() {
    for args in [
        &["fold", "-", "-o", "-", "--quiet"][..],
        &["fold", "-", "-o", "-"],
        &["fold", "-", "--report", "-", "--quiet"],
        &["info", "-"],
        &["info", "-", "--json"],
    ] {
        assert_eq!(without_a_reader(args), (0, String::new()), "{args:?}");
    }
}

#[test]
fn a_closed_standard_error_is_no_panic() {
    let place = Place::new();
    let mut command = Command::new(assert_cmd::cargo::cargo_bin!("origami"));
    command.current_dir(place.path("")).args(["fold", "-", "-o", "a.fold"]);
    let mut child = command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    drop(child.stderr.take());
    child.stdin.take().unwrap().write_all(b"{").unwrap();
    assert_eq!(child.wait().unwrap().code(), Some(1));
}
