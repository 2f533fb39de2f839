//! Circles of files that use each other.
//!
//! A parent module and its own children may: what `mod.rs` defines its children use, and it calls them. So of every circle
//! that has such a parent on top, the children's uses of the parent are taken away; what still goes round is reported.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;

use super::uses::{Modules, Use};

/// Files each of which reaches all others, with the uses between them.
#[derive(Debug)]
pub(crate) struct Circle {
    pub(crate) files: BTreeSet<String>,
    pub(crate) uses: Vec<Use>,
}

/// The files, then a line for each pair of them: `one.rs uses of other.rs: path (line), ..`.
impl fmt::Display for Circle {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}", self.files.iter().map(String::as_str).collect::<Vec<_>>().join(", "))?;
        let mut pairs: BTreeMap<[&str; 2], Vec<String>> = BTreeMap::new();
        for tie in &self.uses {
            pairs.entry([&tie.from, &tie.to]).or_default().push(format!("{} ({})", tie.path, tie.line));
        }
        pairs.iter().try_for_each(|([from, to], uses)| writeln!(f, "    {from} uses of {to}: {}", uses.join(", ")))
    }
}

/// All circles of a crate but those of a parent with its own children.
pub(crate) fn of(modules: &Modules) -> Vec<Circle> {
    let parents = modules.parents();
    let mut circles = Vec::new();
    without_parents(modules.uses().into_iter().collect(), &parents, &mut circles);
    circles
}

fn without_parents(uses: Vec<Use>, parents: &BTreeMap<&str, &str>, circles: &mut Vec<Circle>) {
    for files in knots(&uses) {
        let within = uses.iter().filter(|tie| files.contains(tie.from.as_str()) && files.contains(tie.to.as_str()));
        let is_below = |file: &str, top: &str| {
            std::iter::successors(parents.get(file), |file| parents.get(*file)).any(|parent| *parent == top)
        };
        let top = files.iter().find(|top| files.iter().all(|file| file == *top || is_below(file, top)));
        let of_child =
            |tie: &&Use| top.is_some_and(|top| tie.to == *top && parents.get(tie.from.as_str()) == Some(top));
        let (upward, rest): (Vec<&Use>, Vec<&Use>) = within.partition(of_child);
        let rest = rest.into_iter().cloned().collect();
        if upward.is_empty() {
            circles.push(Circle { files: files.into_iter().map(str::to_owned).collect(), uses: rest });
        } else {
            without_parents(rest, parents, circles);
        }
    }
}

/// Sets of at least two files that reach each other.
fn knots(uses: &[Use]) -> Vec<BTreeSet<&str>> {
    let mut next: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
    for tie in uses {
        next.entry(&tie.from).or_default().insert(&tie.to);
    }
    let reached = |start: &str| {
        let mut reached = BTreeSet::new();
        let mut open: Vec<&str> = next.get(start).into_iter().flatten().copied().collect();
        while let Some(file) = open.pop() {
            if reached.insert(file) {
                open.extend(next.get(file).into_iter().flatten());
            }
        }
        reached
    };
    let reach: BTreeMap<&str, BTreeSet<&str>> = next.keys().map(|file| (*file, reached(file))).collect();
    let knot = |file: &&str| -> BTreeSet<&str> {
        let there_and_back = |other: &&&str| reach.get(**other).is_some_and(|back| back.contains(file));
        reach[file].iter().filter(there_and_back).copied().collect()
    };
    reach.keys().map(knot).filter(|knot| knot.len() > 1).collect::<BTreeSet<_>>().into_iter().collect()
}

mod tests {
    use super::*;

    /// The files of each circle, joined by spaces.
    fn circles_of(files: &[(&str, &str)]) -> Vec<String> {
        of(&Modules::made_up(files)).into_iter().map(|circle| Vec::from_iter(circle.files).join(" ")).collect()
    }

    #[test]
    fn circles_are_found_however_they_are_written() {
        let pair = |a: &str, b: &str| {
            circles_of(&[("lib.rs", "mod a; mod b; mod c;"), ("a.rs", a), ("b.rs", b), ("c.rs", "pub struct C;")])
        };
        let there = "use crate::b::B; pub struct A;";
        let back = [
            "use crate::a::A; pub struct B;",
            "use crate::{a::{self, A as Other}, c::C}; pub struct B;",
            "use super::{a as of_a, c}; pub struct B(of_a::A);",
            "use super::a::*; pub struct B;",
            "pub struct B(Vec<crate::a::A>);",
            "pub fn b() { println!(\"{}\", crate::a::A::new(1)) }",
            "macro_rules! b { ($x:expr) => { $crate::a::A($x) } }",
            "use crate as all; pub struct B(all::a::A);",
        ];
        for back in back {
            assert_eq!(pair(there, back), ["a.rs b.rs"], "{back}");
        }
        let not_back = [
            "use crate::c::C; pub struct B;",
            "use crate::{c::{self, C}}; pub struct B;",
            "use ::a::A; pub struct B;",
            "use a::A; pub struct B; // crate::a",
            "pub(in crate::a) struct B;",
            "pub struct B; #[cfg(test)] mod tests { use crate::a::A; }",
            "pub fn b(a: u32) -> u32 { a + u32::MAX }",
        ];
        for not_back in not_back {
            assert!(pair(there, not_back).is_empty(), "{not_back}");
        }
    }

    #[test]
    fn a_re_export_counts_as_the_file_that_it_leads_to() {
        let through = |root: &str, a: &str| {
            let folder = [
                ("p/mod.rs", "mod x; mod y; pub use self::{x::X, y::*};"),
                ("p/x.rs", "pub struct X(crate::a::A);"),
                ("p/y.rs", "pub struct Y;"),
            ];
            circles_of(&[&[("lib.rs", root), ("a.rs", a)][..], &folder].concat())
        };
        let root = "mod a; mod p; pub use p::{X as Renamed, Y};";
        assert_eq!(through(root, "use crate::p::X; pub struct A;"), ["a.rs p/x.rs"]);
        assert_eq!(through(root, "use crate::Renamed; pub struct A;"), ["a.rs p/x.rs"]);
        assert_eq!(through(root, "use crate::p; pub struct A(p::X);"), ["a.rs p/x.rs"]);
        assert!(through(root, "use crate::p::Y; pub struct A;").is_empty());
        assert!(through(root, "use crate::Y; pub struct A;").is_empty());
    }

    #[test]
    fn only_a_parent_and_its_own_children_may_use_each_other() {
        let family = |x: &str, y: &str| {
            let (root, parent) = ("mod p; mod q;", "mod x; mod y; pub struct P; pub fn p() -> x::X { crate::q::q() }");
            circles_of(&[("lib.rs", root), ("p.rs", parent), ("p/x.rs", x), ("p/y.rs", y), ("q.rs", "pub fn q() {}")])
        };
        assert!(family("pub struct X(super::P);", "pub struct Y(super::P, super::x::X);").is_empty());
        assert_eq!(family("pub struct X(super::y::Y);", "pub struct Y(super::P, super::x::X);"), ["p/x.rs p/y.rs"]);
        // Round through a file that is no child of the parent's.
        let round = [
            ("lib.rs", "mod p; mod q;"),
            ("p.rs", "mod x; pub struct P(crate::q::Q);"),
            ("p/x.rs", "pub struct X(super::P);"),
            ("q.rs", "pub struct Q(crate::p::x::X);"),
        ];
        assert_eq!(circles_of(&round), ["p.rs p/x.rs q.rs"]);
        let circle = of(&Modules::made_up(&round)).remove(0).to_string();
        assert!(circle.contains("    q.rs uses of p/x.rs: crate::p::x::X (1)\n"), "{circle}");
    }
}
