//! Files that are written whole or not at all.

use std::fs::{self, OpenOptions};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use crate::error::Error;

/// Writes a file by `content`. Until that has succeeded the file at `path` stays as it was: the new one is written
/// beside it, brought to the disk and then renamed. Needs the feature `files`.
///
/// The new file has the permissions of the old one, or those of any new file. A symbolic link stays and what it points to
/// is replaced. What is no file (a terminal, a pipe, `/dev/null`) is written to directly.
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
    let mut builder = tempfile::Builder::new();
    builder.prefix(".origami-").suffix(".part");
    // As for any new file; the system takes away what the umask says.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    let beside = builder.tempfile_in(folder)?;
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
