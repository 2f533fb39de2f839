//! What somebody may have meant who has misspelt a name.

use std::path::Path;

/// The name that is most like `given`, if less than a third of the letters are others, missing or swapped.
pub(crate) fn nearest<'a>(given: &str, names: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    within(given.chars().count(), given, names)
}

/// The same where `letters` count.
fn within<'a>(letters: usize, given: &str, names: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    let slips = names.map(|name| (strsim::osa_distance(given, name), name));
    // The first of equals.
    slips.filter(|(slips, _)| 3 * slips < letters).min_by_key(|(slips, _)| *slips).map(|(_, name)| name)
}

/// For a file that is not there: the one beside it with the name that is most like its own.
pub(crate) fn nearest_file(missing: &Path) -> Option<String> {
    let name = missing.file_name()?.to_str()?;
    let folder = missing.parent().filter(|folder| !folder.as_os_str().is_empty());
    let files = std::fs::read_dir(folder.unwrap_or(Path::new("."))).ok()?.flatten();
    let mut names: Vec<String> = files.filter_map(|file| file.file_name().into_string().ok()).collect();
    names.sort_unstable();
    // Extensions are alike anyway.
    let letters = missing.file_stem()?.to_str()?.chars().count();
    let found = within(letters, name, names.iter().map(String::as_str).filter(|other| !other.starts_with('.')))?;
    Some(missing.with_file_name(found).to_string_lossy().into_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_slip_is_seen_and_another_word_is_not() {
        let names = ["miura", "kresling", "waterbomb", "waterbomb-vertex"];
        let nearest = |given| nearest(given, names.into_iter());
        assert_eq!(nearest("miurra"), Some("miura"));
        assert_eq!(nearest("mirua"), Some("miura"));
        assert_eq!(nearest("kressling"), Some("kresling"));
        assert_eq!(nearest("waterbom"), Some("waterbomb"));
        assert_eq!(nearest("hypar"), None);
        assert_eq!(super::nearest("tpu", ["cpu", "gpu"].into_iter()), None);
        assert_eq!(nearest(""), None);
    }

    #[test]
    fn files_are_looked_for_where_they_were_to_be() {
        let folder = tempfile::tempdir().expect("a folder");
        std::fs::write(folder.path().join("miura.fold"), "").expect("written");
        let found = nearest_file(&folder.path().join("miura.fodl"));
        assert_eq!(found.as_deref(), folder.path().join("miura.fold").to_str());
        assert_eq!(nearest_file(&folder.path().join("crane.fold")), None);
        assert_eq!(nearest_file(&folder.path().join("none/miura.fold")), None);
    }
}
