//! The quick study of contact, and what its figures have to show.

use origami_study::{Cell, Options, Part, Study, Table, contact};

fn table<'a>(study: &'a Study, name: &str) -> &'a Table {
    let of = |part: &'a Part| match part {
        Part::Table { file, table, .. } if file == name => Some(table),
        _ => None,
    };
    study.parts.iter().find_map(of).expect(name)
}

fn column<'a>(table: &'a Table, key: &str) -> Vec<&'a Cell> {
    let place = table.columns.iter().position(|column| column.key == key).expect(key);
    table.rows.iter().map(|row| &row[place]).collect()
}

#[test]
fn nothing_crosses_and_what_is_missed_is_told() {
    let study = contact::study(&Options { quick: true, ..Options::default() }, &mut ()).expect("generated patterns");
    for name in [
        "contact-patterns",
        "contact-touching",
        "contact-told",
        "contact-maps",
        "contact-accordions",
        "contact-narrowed",
    ] {
        let crossings = column(table(&study, name), "crossings");
        assert!(
            !crossings.is_empty() && crossings.iter().all(|cell| **cell == Cell::Count(0)),
            "{name}: {crossings:?}"
        );
    }
    let free = column(table(&study, "contact-patterns"), "crossings_free");
    assert!(free.iter().any(|cell| matches!(cell, Cell::Count(n) if *n > 0)), "freely some cross: {free:?}");
    let asked = table(&study, "contact-asked");
    let all = column(asked, "what").into_iter().zip(column(asked, "found")).zip(column(asked, "kept"));
    let missed: Vec<_> = all.filter(|(_, kept)| **kept != Cell::Flag(true)).collect();
    println!("{missed:?}");
    assert!(asked.rows.len() > 15 && missed.len() < 3, "{missed:?}");
}
