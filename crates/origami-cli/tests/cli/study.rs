//! `origami study`, in builds with it and without.

use crate::place::Place;

#[cfg(not(feature = "study"))]
#[test]
fn a_build_without_it_says_so() {
    let place = Place::new();
    place.run("study accuracy -o out").fails(1, "origami study: this build is without it (feature `study`)");
    assert_eq!(place.names(), ["square.fold"]);
}

#[cfg(feature = "study")]
mod present {
    use super::*;

    /// Names of the files with this extension in `out`, without it, in order.
    fn stems(place: &Place, extension: &str) -> Vec<String> {
        let entries = std::fs::read_dir(place.path("out")).unwrap().map(|entry| entry.unwrap().path());
        let own = entries.filter(|path| path.extension().is_some_and(|e| e == extension));
        let mut stems: Vec<String> = own.map(|p| p.file_stem().unwrap().to_str().unwrap().to_owned()).collect();
        stems.sort();
        stems
    }

    /// All files that the document names are there, and its tables can be read.
    fn is_whole(place: &Place, name: &str) {
        let document = place.text(&format!("out/{name}.md"));
        assert!(document.starts_with("# "), "{document}");
        for link in document.split("](").skip(1).filter_map(|rest| rest.split(')').next()) {
            assert!(place.has(&format!("out/{link}")) || link.contains("//"), "{link}");
        }
        let tables = stems(place, "csv");
        assert_eq!(tables, stems(place, "json"));
        for table in &tables {
            let path = format!("out/{table}.csv");
            let mut reader = csv::Reader::from_path(place.path(&path)).unwrap();
            let rows = reader.records().collect::<Result<Vec<_>, _>>().unwrap().len();
            assert_eq!(place.json(&format!("out/{table}.json")).as_array().unwrap().len(), rows, "{path}");
        }
        for plot in stems(place, "svg") {
            assert!(place.text(&format!("out/{plot}.svg")).ends_with("</svg>\n"), "{plot}");
        }
        let files = 1 + 2 * tables.len() + stems(place, "svg").len();
        assert_eq!(std::fs::read_dir(place.path("out")).unwrap().count(), files, "nothing else is left behind");
    }

    #[test]
    fn accuracy_of_a_pattern_is_written() {
        let place = Place::new();
        let ran = place.run("study accuracy square.fold --quick --time-limit 5 -o out");
        let line = ran.succeeds();
        assert!(line.starts_with("out/accuracy.md and ") && line.contains(" beside it: "), "{line}");
        is_whole(&place, "accuracy");
    }

    #[test]
    fn stability_is_written() {
        let place = Place::new();
        let ran = place.run("study stability --quick --time-limit 1 --quiet -o out");
        assert_eq!(ran.succeeds(), "");
        is_whole(&place, "stability");
    }

    #[test]
    fn what_cannot_be_done_is_refused_before_any_work() {
        let place = Place::new();
        place.put("file", "");
        for (words, expected) in [
            ("study", "<STUDY>"),
            ("study speed -o out", "accuracy, stability, flat, contact or backwards"),
            ("study accuracy square.fold", "--output"),
            ("study accuracy file -o out", "error: file: line 1: the file is empty"),
            ("study accuracy missing.fold -o out", "error: missing.fold: No such file"),
            ("study accuracy kite -o out", "error: kite: No such file"),
            ("study accuracy square.fold ./square.fold -o out", "./square.fold: another pattern is called square too"),
            ("study accuracy square.fold -o file", "file: is no folder; expected one"),
            ("study accuracy square.fold -o -", "-: is no folder; expected one"),
            ("study accuracy square.fold -o file/out", "error: file/out: Not a directory"),
            ("study accuracy square.fold -o out --time-limit 0", "expected a finite number greater than 0"),
            ("study accuracy square.fold -o out --backend auto", "cpu or gpu"),
            ("study stability square.fold -o out", "square.fold: stability has scenes of its own; expected no pattern"),
        ] {
            let ran = place.run(words);
            ran.fails(1, expected);
            assert_eq!(ran.stdout, "", "{words}");
            assert_eq!(place.names(), ["file", "square.fold"], "{words} leaves nothing behind");
        }
    }

    #[test]
    fn a_folder_in_the_place_of_the_document_is_found_before_the_study() {
        let place = Place::new();
        std::fs::create_dir_all(place.path("out/accuracy.md")).unwrap();
        let ran = place.run("study accuracy square.fold -o out");
        ran.fails(1, "out/accuracy.md: is a folder; expected a file or nothing there");
    }

    #[test]
    fn an_adapter_without_effect_is_told() {
        let place = Place::new();
        let ran = place.run("study accuracy square.fold --quick --time-limit 0.001 --adapter llvmpipe -o out");
        assert_eq!((ran.code, ran.stderr.as_str()), (0, "warning: --adapter has no effect with --backend cpu\n"));
    }
}
