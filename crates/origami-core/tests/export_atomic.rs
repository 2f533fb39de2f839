//! Files are written whole or not at all.

use std::fs;
use std::io::{self, Write};
use std::path::Path;

use origami_core::Error;
use origami_core::export::{check_writable, remove_unfinished, write_whole};

fn put<'a>(text: &'a str) -> impl FnOnce(&mut dyn Write) -> Result<(), Error> + 'a {
    move |writer| writer.write_all(text.as_bytes()).map_err(|source| Error::Io { path: "-".into(), source })
}

fn names(folder: &Path) -> Vec<String> {
    let mut names: Vec<_> =
        fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").file_name()).collect();
    names.sort();
    names.into_iter().map(|name| name.to_string_lossy().into_owned()).collect()
}

#[test]
fn files_are_made_and_replaced() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.fold");
    write_whole(&path, put("one, longer than two")).expect("written");
    write_whole(&path, put("two")).expect("written");
    assert_eq!(fs::read_to_string(&path).expect("read"), "two");
    assert_eq!(names(folder.path()), ["a.fold"]);
}

#[test]
fn a_failure_leaves_the_old_file_and_nothing_else() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.fold");
    fs::write(&path, "old").expect("written");
    let fail = |writer: &mut dyn Write| {
        put("half a new file")(writer)?;
        Err(Error::invalid("here", "a problem", "none"))
    };
    let error = write_whole(&path, fail).expect_err("fails");
    assert!(matches!(error, Error::Invalid { .. }), "{error}");
    assert_eq!(fs::read_to_string(&path).expect("read"), "old");
    assert_eq!(names(folder.path()), ["a.fold"]);
    assert!(write_whole(folder.path().join("b.fold"), fail).is_err());
    assert_eq!(names(folder.path()), ["a.fold"]);
}

#[test]
fn failures_to_write_name_the_file() {
    let folder = tempfile::tempdir().expect("a folder");
    let full = |_: &mut dyn Write| Err(Error::Io { path: "-".into(), source: io::ErrorKind::StorageFull.into() });
    let error = write_whole(folder.path().join("a.fold"), full).expect_err("full").to_string();
    assert!(error.contains("a.fold: "), "{error}");

    let error = write_whole(folder.path().join("none/a.fold"), put("")).expect_err("no folder").to_string();
    assert!(error.contains("a.fold: there is no folder") && error.ends_with("none"), "{error}");
    let error = write_whole(folder.path(), put("")).expect_err("a folder").to_string();
    assert!(error.contains("directory"), "{error}");
    fs::write(folder.path().join("file"), "").expect("written");
    for bad in [folder.path().join("file/a.fold"), folder.path().join(".."), "/".into()] {
        assert!(matches!(write_whole(&bad, put("")), Err(Error::Io { .. })), "{bad:?}");
    }
    assert!(matches!(write_whole("", put("")), Err(Error::Io { .. })));
    assert_eq!(names(folder.path()), ["file"]);
}

#[test]
fn content_is_not_asked_for_where_there_is_no_place_for_it() {
    let folder = tempfile::tempdir().expect("a folder");
    let unwanted = |_: &mut dyn Write| panic!("there is no folder to write to");
    assert!(write_whole(folder.path().join("none/a.fold"), unwanted).is_err());
}

#[test]
fn what_cannot_be_written_is_seen_before() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.fold");
    check_writable(&path).expect("can be written");
    assert!(names(folder.path()).is_empty(), "trying leaves nothing behind");
    fs::write(&path, "old").expect("written");
    check_writable(&path).expect("can be replaced");
    assert_eq!(fs::read_to_string(&path).expect("read"), "old");
    for bad in [folder.path().join("none/a.fold"), folder.path().join("a.fold/b.fold"), folder.path().into()] {
        let told = check_writable(&bad).expect_err("cannot be written").to_string();
        assert_eq!(told, write_whole(&bad, put("")).expect_err("cannot be written").to_string());
    }
}

#[test]
fn what_a_killed_program_left_is_removed_after_a_day() {
    let folder = tempfile::tempdir().expect("a folder");
    let day = std::time::Duration::from_hours(24);
    for (name, age) in [(".origami-old.part", 25), (".origami-new.part", 0), ("old.part", 25), (".origami-old", 25)] {
        let file = fs::File::create(folder.path().join(name)).expect("made");
        file.set_modified(std::time::SystemTime::now() - day / 24 * age).expect("set");
    }
    fs::create_dir(folder.path().join(".origami-folder.part")).expect("made");
    remove_unfinished(folder.path());
    assert_eq!(names(folder.path()), [".origami-folder.part", ".origami-new.part", ".origami-old", "old.part"]);
    remove_unfinished(folder.path().join("none"));
}

#[cfg(unix)]
mod unix {
    use std::os::fd::AsRawFd;
    use std::os::unix::fs::{MetadataExt, PermissionsExt, symlink};
    use std::process::Command;

    use super::*;

    fn mode(path: &Path) -> u32 {
        fs::metadata(path).expect("a file").permissions().mode() & 0o7777
    }

    #[test]
    fn permissions_are_those_of_the_old_file_or_of_any_new_one() {
        let folder = tempfile::tempdir().expect("a folder");
        let plain = folder.path().join("plain");
        fs::write(&plain, "").expect("written");
        let new = folder.path().join("new");
        write_whole(&new, put("")).expect("written");
        assert_eq!(mode(&new), mode(&plain));
        for bits in [0o600, 0o640, 0o777] {
            fs::set_permissions(&new, fs::Permissions::from_mode(bits)).expect("set");
            write_whole(&new, put("x")).expect("written");
            assert_eq!(mode(&new), bits);
        }
    }

    #[test]
    fn links_stay_links() {
        let folder = tempfile::tempdir().expect("a folder");
        fs::create_dir(folder.path().join("sub")).expect("made");
        let target = folder.path().join("sub/target");
        let link = folder.path().join("link");
        let link_to_link = folder.path().join("link2");
        symlink("sub/target", &link).expect("linked");
        symlink(&link, &link_to_link).expect("linked");
        for text in ["through a dangling link", "through a good one"] {
            write_whole(&link_to_link, put(text)).expect("written");
            assert!(fs::symlink_metadata(&link).expect("a link").is_symlink());
            assert_eq!(fs::read_to_string(&target).expect("read"), text);
        }
        assert_eq!(names(&folder.path().join("sub")), ["target"]);

        symlink("round", folder.path().join("round")).expect("linked");
        assert!(matches!(write_whole(folder.path().join("round"), put("")), Err(Error::Io { .. })));
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn a_folder_that_cannot_be_written_to_is_named_and_not_a_file_of_ours() {
        // Not even the superuser makes files there.
        for told in [write_whole("/sys/a.fold", put("")), check_writable("/sys/a.fold")] {
            let told = told.expect_err("refused").to_string();
            assert!(told.starts_with("/sys/a.fold: nothing can be written into the folder /sys: "), "{told}");
            assert!(!told.contains(".origami-"), "{told}");
        }
    }

    #[test]
    fn devices_are_written_to() {
        let before = fs::metadata("/dev/null").expect("a device").ino();
        write_whole("/dev/null", put("nothing")).expect("written");
        assert_eq!(fs::metadata("/dev/null").expect("a device").ino(), before);
    }

    #[test]
    fn pipes_are_written_to() {
        let folder = tempfile::tempdir().expect("a folder");
        let pipe = folder.path().join("pipe");
        assert!(Command::new("mkfifo").arg(&pipe).status().expect("mkfifo").success());
        let reader = std::thread::spawn({
            let pipe = pipe.clone();
            move || fs::read_to_string(pipe)
        });
        write_whole(&pipe, put("through a pipe")).expect("written");
        assert_eq!(reader.join().expect("joined").expect("read"), "through a pipe");
        assert_eq!(names(folder.path()), ["pipe"]);
    }

    /// What `/dev/stdout` is when the shell appends it to a file.
    #[cfg(target_os = "linux")]
    #[test]
    fn open_files_are_appended_to() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("log");
        fs::write(&path, "before, ").expect("written");
        let open = fs::OpenOptions::new().append(true).open(&path).expect("open");
        write_whole(format!("/dev/fd/{}", open.as_raw_fd()), put("after")).expect("written");
        assert_eq!(fs::read_to_string(&path).expect("read"), "before, after");
    }
}
