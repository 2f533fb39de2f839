//! Files that are written whole or not at all.

use std::fs::{self, File, OpenOptions};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};

use crate::error::Error;

/// Names of files that are not whole yet begin and end so.
const UNFINISHED: [&str; 2] = [".origami-", ".part"];
/// No file takes longer to write.
const STALE: Duration = Duration::from_hours(24);

/// Writes a file by `content`. Until that has succeeded the file at `path` stays as it was: the new one is written
/// beside it, brought to the disk and then renamed. Needs the feature `files`.
///
/// The new file has the permissions of the old one, or those of any new file, and belongs to whoever writes it; other hard
/// links keep the old one. A symbolic link stays and what it points to is replaced. What is no file (a terminal, a pipe, `/dev/null`) is written to directly.
///
/// # Errors
/// [`Error::Io`] with this path if it cannot be written; and whatever `content` returns.
pub fn write_whole(
    path: impl AsRef<Path>,
    content: impl FnOnce(&mut dyn Write) -> Result<(), Error>,
) -> Result<(), Error> {
    let path = path.as_ref();
    let name = |source| Error::Io { path: path.display().to_string(), source };
    let written = match destination(path).map_err(name)? {
        Destination::Stream => {
            // Appending: standard output may be a file that has something in it already.
            let mut stream = BufWriter::new(OpenOptions::new().append(true).open(path).map_err(name)?);
            content(&mut stream).and_then(|()| stream.flush().map_err(name))
        }
        Destination::File(file) => replace(&file, name, content),
    };
    written.map_err(|error| match error {
        Error::Io { path, source } if path == "-" => name(source),
        other => other,
    })
}

/// Whether [`write_whole`] may write to `path`: tried without leaving anything there. What is no file is not tried, since a
/// pipe is opened only once. Needs the feature `files`.
///
/// # Errors
/// [`Error::Io`] with this path if it may not.
pub fn check_writable(path: impl AsRef<Path>) -> Result<(), Error> {
    let path = path.as_ref();
    let tried = destination(path).and_then(|destination| match destination {
        Destination::Stream => Ok(()),
        Destination::File(file) => beside(&file).map(drop),
    });
    tried.map_err(|source| Error::Io { path: path.display().to_string(), source })
}

/// Removes the unfinished files that programs which were killed have left in `folder`: those of [`write_whole`] that are
/// older than a day. What cannot be seen or removed stays. Needs the feature `files`.
pub fn remove_unfinished(folder: impl AsRef<Path>) {
    let [begin, end] = UNFINISHED;
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let name = entry.file_name();
        let is_ours = name.to_str().is_some_and(|name| name.starts_with(begin) && name.ends_with(end));
        let is_old = |metadata: fs::Metadata| {
            let age = SystemTime::now().duration_since(metadata.modified().ok()?).ok()?;
            Some(metadata.is_file() && age > STALE)
        };
        if is_ours && entry.metadata().ok().and_then(is_old) == Some(true) {
            // Another's, or taken away by another program at the same time.
            let _ = fs::remove_file(entry.path());
        }
    }
}

fn replace(
    path: &Path,
    name: impl Fn(io::Error) -> Error + Copy,
    content: impl FnOnce(&mut dyn Write) -> Result<(), Error>,
) -> Result<(), Error> {
    let mut beside = beside(path).map_err(name)?;
    let mut buffer = BufWriter::new(beside.as_file_mut());
    content(&mut buffer)?;
    buffer.flush().map_err(name)?;
    drop(buffer);
    beside.as_file().sync_all().map_err(name)?;
    beside.persist(path).map(drop).map_err(|error| name(error.error))
}

/// A new file in the folder of `path`, which is deleted when dropped.
fn beside(path: &Path) -> io::Result<tempfile::NamedTempFile> {
    let old = match OpenOptions::new().write(true).open(path) {
        Ok(file) => Some(file.metadata()?.permissions()),
        Err(error) if error.kind() == io::ErrorKind::NotFound => None,
        Err(error) => return Err(error),
    };
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    if !folder.is_dir() {
        let problem = format!("there is no folder {}", folder.display());
        return Err(io::Error::new(io::ErrorKind::NotFound, problem));
    }
    let [prefix, suffix] = UNFINISHED;
    // Opened here, with the permissions of any new file: an error then does not name a file that nobody has asked for.
    let open = |path: &Path| File::options().write(true).create_new(true).open(path);
    let beside = tempfile::Builder::new().prefix(prefix).suffix(suffix).make_in(folder, open);
    let beside = beside.map_err(|error| {
        let problem = format!("nothing can be written into the folder {}: {error}", folder.display());
        io::Error::new(error.kind(), problem)
    })?;
    if let Some(old) = old {
        beside.as_file().set_permissions(old)?;
    }
    Ok(beside)
}

enum Destination {
    /// A file, which may exist or not, with links followed.
    File(PathBuf),
    /// Something that cannot be replaced.
    Stream,
}

fn destination(path: &Path) -> io::Result<Destination> {
    if path.file_name().is_none() {
        return Err(io::Error::new(io::ErrorKind::InvalidInput, "this names no file"));
    }
    let mut target = path.to_owned();
    // As many links as Linux follows.
    for _ in 0..40 {
        // Files that are open already, standard output among them.
        if target.starts_with("/proc") || target.starts_with("/dev/fd") {
            return Ok(Destination::Stream);
        }
        let kind = match fs::symlink_metadata(&target) {
            Ok(metadata) => metadata.file_type(),
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(Destination::File(target)),
            Err(error) => return Err(error),
        };
        if kind.is_symlink() {
            let link = fs::read_link(&target)?;
            target = target.parent().map(|folder| folder.join(&link)).unwrap_or(link);
        } else if kind.is_dir() {
            return Err(io::ErrorKind::IsADirectory.into());
        } else if kind.is_file() {
            return Ok(Destination::File(target));
        } else {
            return Ok(Destination::Stream);
        }
    }
    Err(io::Error::other("too many symbolic links"))
}
