//! Keys that FOLD does not have and that are nearly one that it has: as a rule a slip of the pen, which would otherwise go
//! unread without a word.

/// All keys of FOLD 1.2, and one of 1.0.
const KNOWN: [&str; 28] = [
    "file_spec",
    "file_creator",
    "file_author",
    "file_title",
    "file_description",
    "file_classes",
    "file_frames",
    "frame_author",
    "frame_title",
    "frame_description",
    "frame_classes",
    "frame_attributes",
    "frame_unit",
    "frame_parent",
    "frame_inherit",
    "vertices_coords",
    "vertices_vertices",
    "vertices_edges",
    "vertices_faces",
    "edges_vertices",
    "edges_faces",
    "edges_assignment",
    "edges_foldAngle",
    "edges_length",
    "faces_vertices",
    "faces_edges",
    "faces_faces",
    "faceOrders",
];
/// More slips than this are another word.
const SLIPS: usize = 2;

/// The key that `key` was meant to be; `None` for keys of FOLD, for those of a program's own (`program:key`), and for
/// words of another kind.
pub(super) fn meant(key: &str) -> Option<&'static str> {
    const ALSO_KNOWN: [&str; 2] = ["edgeOrders", "edges_foldAngles"];
    // No longer text can be meant.
    if key.contains(':') || key.len() > 40 || KNOWN.contains(&key) || ALSO_KNOWN.contains(&key) {
        return None;
    }
    let letters = |text: &str| -> Vec<char> {
        text.chars().filter(|c| *c != '_' && *c != '-').flat_map(char::to_lowercase).collect()
    };
    let written = letters(key);
    let near = |known: &&'static str| {
        let known = letters(known);
        // `vertices_coordinates` is longer by more than slips.
        let longer = written.len() > known.len() && written.starts_with(&known[..known.len() - 1]);
        if longer { 1 } else { distance(&written, &known) }
    };
    let best = KNOWN.iter().min_by_key(|known| near(known))?;
    (near(best) <= SLIPS).then_some(*best)
}

/// How many letters must be put in, left out or changed to get from one word to the other (Levenshtein).
fn distance(from: &[char], to: &[char]) -> usize {
    let mut row: Vec<usize> = (0..=to.len()).collect();
    for (i, a) in from.iter().enumerate() {
        let mut diagonal = std::mem::replace(&mut row[0], i + 1);
        for (j, b) in to.iter().enumerate() {
            let change = diagonal + usize::from(a != b);
            diagonal = row[j + 1];
            row[j + 1] = change.min(diagonal + 1).min(row[j] + 1);
        }
    }
    row[to.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slips_of_the_pen() {
        let slips = [
            ("edges_assignments", "edges_assignment"),
            ("edge_vertices", "edges_vertices"),
            ("edges_fold_angle", "edges_foldAngle"),
            ("edgesFoldAngle", "edges_foldAngle"),
            ("vertices_coord", "vertices_coords"),
            ("vertices_coordinates", "vertices_coords"),
            ("faces_vertexes", "faces_vertices"),
            ("Faces_Vertices", "faces_vertices"),
            ("frame_class", "frame_classes"),
        ];
        for (key, known) in slips {
            assert_eq!(meant(key), Some(known), "{key}");
        }
        for key in
            KNOWN.into_iter().chain(["edgeOrders", "edges_foldAngles", "edges_origami:ea", "faces_layers", "note"])
        {
            assert_eq!(meant(key), None, "{key}");
        }
    }

    #[test]
    fn distances() {
        let of = |a: &str, b: &str| distance(&a.chars().collect::<Vec<_>>(), &b.chars().collect::<Vec<_>>());
        assert_eq!([of("kitten", "sitting"), of("", "abc"), of("abc", "abc"), of("ab", "ba")], [3, 3, 0, 2]);
    }
}
