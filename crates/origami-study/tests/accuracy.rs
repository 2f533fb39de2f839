//! The quick study of accuracy, and what its figures have to show.

use origami_core::CreasePattern;
use origami_core::generate::catalog;
use origami_study::{Cell, Options, Part, Study, Table, Watch, accuracy};

/// Counts what it is told.
#[derive(Default)]
struct Count {
    announced: usize,
    ran: usize,
}

impl Watch for Count {
    fn begins(&mut self, runs: usize) {
        self.announced = runs;
    }

    fn ran(&mut self, _: &str) {
        self.ran += 1;
    }
}

fn table<'a>(study: &'a Study, name: &str) -> Option<&'a Table> {
    study.parts.iter().find_map(|part| match part {
        Part::Table { file, table, .. } if file == name => Some(table),
        _ => None,
    })
}

/// The cells of a column, in the rows whose column `key` is `value`.
fn cells<'a>(table: &'a Table, column: &str, key: &str, value: &str) -> Vec<&'a Cell> {
    let place = |key: &str| table.columns.iter().position(|column| column.key == key).expect("a column of that key");
    let (column, key) = (place(column), place(key));
    table.rows.iter().filter(|row| row[key] == Cell::from(value)).map(|row| &row[column]).collect()
}

fn numbers(cells: &[&Cell]) -> Vec<f64> {
    cells.iter().filter_map(|cell| if let Cell::Number(x) = cell { Some(*x) } else { None }).collect()
}

#[test]
fn the_quick_study_shows_what_it_has_to() {
    let mut count = Count::default();
    let study = accuracy::study(&Options { quick: true, ..Options::default() }, &mut count).expect("shipped scenes");
    assert!(count.announced > 0 && count.ran == count.announced, "{} of {}", count.ran, count.announced);

    // No row without an answer: a number that is not one would be a result that nobody can use.
    let tables = study.parts.iter().filter_map(|part| match part {
        Part::Table { file, table, .. } => Some((file, table)),
        _ => None,
    });
    let mut rows = 0;
    for (file, table) in tables {
        rows += table.rows.len();
        let nan = |cell: &Cell| matches!(cell, Cell::Number(x) if x.is_nan());
        assert!(!table.rows.iter().flatten().any(nan), "{file}");
    }
    assert!(rows > 300, "{rows} rows");

    // A jump of a Miura sheet of 10 x 10: METHOD's figures are 12 180 evaluations of the paper's scheme, 200 of FIRE.
    let runs = table(&study, "runs-miura-10x10-60").expect("the jump");
    let evaluations = |solver: &str| match cells(runs, "evaluations_1e-4", "solver", solver)[..] {
        [Cell::Count(n)] => *n,
        ref other => panic!("{solver}: {other:?}"),
    };
    assert!((9_000..15_000).contains(&evaluations("paper")), "{}", evaluations("paper"));
    for relax in ["relax", "relax, mixed"] {
        assert!(evaluations(relax) * 30 < evaluations("paper"), "{relax}: {}", evaluations(relax));
    }
    for solver in ["newton after relax", "newton in a jump"] {
        let error = numbers(&cells(runs, "error_max", "solver", solver));
        assert!(error.len() == 1 && error[0] < 1e-9, "{solver}: {error:?}");
    }

    let closed = table(&study, "closed-forms").expect("closed forms");
    let errors = |solver: &str| numbers(&cells(closed, "error", "solver", solver));
    assert_eq!(errors("newton").len(), 9);
    assert!(errors("newton").iter().all(|error| *error < 1e-8), "{:?}", errors("newton"));
    assert!(errors("relax").iter().all(|error| *error < 1e-4), "{:?}", errors("relax"));
    let closures = |solver: &str| numbers(&cells(closed, "closure", "solver", solver));
    assert!(closures("newton").len() >= 5 && closures("newton").iter().all(|c| *c < 1e-8), "{:?}", closures("newton"));

    let claims = table(&study, "claims").expect("claims");
    let place = claims.columns.iter().position(|column| column.key == "kept").expect("a column");
    let count = |flag: bool| claims.rows.iter().filter(|row| row[place] == Cell::Flag(flag)).count();
    assert!(count(true) >= 15 && count(true) >= 19 * count(false), "{} kept, {} not", count(true), count(false));

    let transient = table(&study, "transient").expect("transients");
    for (integrator, order) in [("euler", 1.0), ("verlet", 2.0)] {
        let measured = numbers(&cells(transient, "order", "integrator", integrator));
        assert!(measured.len() >= 10 && measured.iter().all(|o| (o - order).abs() < 0.2), "{integrator}: {measured:?}");
    }
}

#[test]
fn a_pattern_of_the_users_is_studied_alone() {
    let pattern: CreasePattern = catalog::generate("single-crease", &[]).expect("a pattern");
    let options = Options { patterns: vec![("mine".into(), pattern)], quick: true, ..Options::default() };
    let study = accuracy::study(&options, &mut ()).expect("a model");
    let ratios = table(&study, "ratios").expect("ratios");
    assert_eq!(ratios.rows.len(), 1);
    assert!(table(&study, "closed-forms").is_none());
}

#[test]
fn what_there_is_no_time_for_is_named() {
    let time_limit = Some(std::time::Duration::ZERO);
    let study = accuracy::study(&Options { quick: true, time_limit, ..Options::default() }, &mut ()).expect("scenes");
    let told = study.parts.iter().any(|part| matches!(part, Part::Text(text) if text.contains("left out")));
    assert!(told);
    assert!(table(&study, "ratios").is_some_and(|ratios| ratios.rows.is_empty()));
}
