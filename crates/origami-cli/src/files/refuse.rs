//! What is refused before any work: to replace an input, and to write where nothing can be written.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use origami::export::{check_writable, remove_unfinished};

use super::{Destination, Input, Target};

/// No output may be one of the inputs, under whatever name: what was folded is all that is left of a pattern then.
///
/// # Errors
/// Which one is.
pub(crate) fn refuse_replaced<'a>(inputs: &[Input], targets: impl Iterator<Item = &'a Target>) -> Result<(), String> {
    let identities = inputs.iter().filter_map(|input| input.file().and_then(Identity::of));
    let identities: BTreeSet<Identity> = identities.collect();
    for target in targets {
        if let Destination::File(path) = &target.destination
            && Identity::of(path).is_some_and(|identity| identities.contains(&identity))
        {
            let what = "would be replaced by what is made from it";
            return Err(format!("{}: {what}; expected another file or folder", path.display()));
        }
    }
    Ok(())
}

/// Whether both paths lead to one file that is there.
pub(crate) fn is_same_file(one: &Path, other: &Path) -> bool {
    Identity::of(one).is_some_and(|identity| Identity::of(other) == Some(identity))
}

/// Which file a path leads to; equal for hard links too, where the system tells them.
#[derive(PartialEq, Eq, PartialOrd, Ord)]
enum Identity {
    #[cfg(unix)]
    Node(u64, u64),
    #[cfg(not(unix))]
    Path(PathBuf),
}

impl Identity {
    /// `None` for what is not there, or is no file that could be lost.
    fn of(path: &Path) -> Option<Self> {
        let metadata = std::fs::metadata(path).ok().filter(std::fs::Metadata::is_file)?;
        #[cfg(unix)]
        {
            use std::os::unix::fs::MetadataExt;

            Some(Self::Node(metadata.dev(), metadata.ino()))
        }
        #[cfg(not(unix))]
        {
            drop(metadata);
            path.canonicalize().ok().map(Self::Path)
        }
    }
}

/// Every file can be written, as far as trying tells; where its folder is still to be made, the folder above can.
///
/// # Errors
/// What the system says of the first that cannot.
pub(crate) fn refuse_unwritable<'a>(paths: impl IntoIterator<Item = &'a Path>) -> Result<(), String> {
    let mut folders: BTreeSet<PathBuf> = BTreeSet::new();
    for path in paths {
        let folder = folder_of(path);
        // One new file says enough of a folder; one that is there already may be closed to us.
        if folders.contains(folder) && !path.exists() {
            continue;
        }
        folders.insert(folder.to_owned());
        let told = |error: origami::Error| error.to_string();
        match folder.is_dir() {
            true => check_writable(path).map_err(told)?,
            false => {
                let above = folder.ancestors().map(named).find(|above| above.exists()).unwrap_or(Path::new("."));
                if !above.is_dir() {
                    let expected = "expected one, or a path where one can be made";
                    return Err(format!("{}: {} is no folder; {expected}", path.display(), above.display()));
                }
                check_writable(above.join(folder.file_name().unwrap_or_default())).map_err(told)?;
            }
        }
    }
    Ok(())
}

/// Removes what programs that were killed have left in the folders of these files.
pub(crate) fn tidy<'a>(paths: impl IntoIterator<Item = &'a Path>) {
    let folders: BTreeSet<&Path> = paths.into_iter().map(folder_of).collect();
    folders.into_iter().for_each(remove_unfinished);
}

fn folder_of(path: &Path) -> &Path {
    named(path.parent().unwrap_or(Path::new("")))
}

/// The folder at hand has a name too.
fn named(folder: &Path) -> &Path {
    if folder.as_os_str().is_empty() { Path::new(".") } else { folder }
}
