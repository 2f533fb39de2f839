//! Connections: who may connect, and what each gets.

use std::io;
use std::net::{TcpListener, TcpStream};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;
use std::time::Duration;

use origami::session::Reading;

use super::computer::Chosen;
use super::http::{Head, answer};
use super::secret::same;
use super::socket;
use crate::console;

/// Connections at once: a browser opens six for one page, and each page keeps one.
const MOST_CONNECTIONS: usize = 64;
/// How long a request or an answer may take.
const PATIENCE: Duration = Duration::from_secs(10);

/// What all connections share.
pub(super) struct Server {
    /// The first part of every path.
    pub(super) secret: String,
    /// What each page opens first.
    pub(super) first: Option<First>,
    /// How pages read files.
    pub(super) reading: Reading,
    pub(super) computer: Chosen,
}

/// A file as it was read.
pub(super) struct First {
    pub(super) name: String,
    pub(super) bytes: Vec<u8>,
}

/// Takes connections, each on a thread of its own, as long as there are any.
pub(super) fn serve(listener: &TcpListener, server: &Arc<Server>) {
    let connections = Arc::new(AtomicUsize::new(0));
    for stream in listener.incoming() {
        // Without a descriptor for the next one it comes back a little later.
        let Ok(stream) = stream else {
            thread::sleep(Duration::from_millis(50));
            continue;
        };
        if connections.load(Ordering::Relaxed) >= MOST_CONNECTIONS {
            continue;
        }
        connections.fetch_add(1, Ordering::Relaxed);
        let counted = Counted(Arc::clone(&connections));
        let server = Arc::clone(server);
        let spawned = thread::Builder::new().name("page".to_owned()).spawn(move || {
            let _counted = counted;
            // A connection that breaks is the other side's business.
            let _ = server.connection(stream);
        });
        if let Err(error) = spawned {
            console::warning(format!("a page was turned away: {error}"));
        }
    }
}

/// One connection, as long as it is there.
struct Counted(Arc<AtomicUsize>);

impl Drop for Counted {
    fn drop(&mut self) {
        self.0.fetch_sub(1, Ordering::Relaxed);
    }
}

impl Server {
    fn connection(&self, mut stream: TcpStream) -> io::Result<()> {
        stream.set_read_timeout(Some(PATIENCE))?;
        stream.set_write_timeout(Some(PATIENCE))?;
        stream.set_nodelay(true)?;
        let bytes = peeked(&stream)?;
        let head = Head::read(&bytes[..])?;
        let host = head.field("host").unwrap_or_default().to_owned();
        let refuse = |stream: &mut TcpStream, status: &str, why: &str| {
            answer(stream, status, "text/plain; charset=utf-8", "127.0.0.1", &[], why.as_bytes())
        };
        if !head.is_local() {
            consume(&mut stream, bytes.len())?;
            return refuse(
                &mut stream,
                "421 Misdirected Request",
                "This program answers to 127.0.0.1 and localhost only.\n",
            );
        }
        let path = head.path.split('?').next().unwrap_or_default();
        let known = path.strip_prefix('/').and_then(|path| path.split_once('/'));
        let Some((_, name)) = known.filter(|(secret, _)| same(secret, &self.secret)) else {
            consume(&mut stream, bytes.len())?;
            return refuse(
                &mut stream,
                "404 Not Found",
                "Nothing is here. The address that `origami view` printed has a secret in it.\n",
            );
        };
        if name == "socket" {
            if !head.is_own() {
                consume(&mut stream, bytes.len())?;
                return refuse(&mut stream, "403 Forbidden", "A page from elsewhere may not fold.\n");
            }
            return socket::run(stream, &self.computer, &self.reading);
        }
        consume(&mut stream, bytes.len())?;
        if head.method != "GET" {
            return refuse(&mut stream, "405 Method Not Allowed", "Only GET.\n");
        }
        if name == "first" {
            let Some(first) = &self.first else {
                return answer(&mut stream, "204 No Content", "text/plain; charset=utf-8", &host, &[], b"");
            };
            let named = percent_encoded(&first.name);
            let more = [("X-Name", named.as_str())];
            return answer(&mut stream, "200 OK", "application/octet-stream", &host, &more, &first.bytes);
        }
        let name = if name.is_empty() { "index.html" } else { name };
        match origami_page::file(name) {
            Some(file) => answer(&mut stream, "200 OK", file.media, &host, &[], file.text.as_bytes()),
            None => refuse(&mut stream, "404 Not Found", "There is no such file.\n"),
        }
    }
}

/// What a header can hold of a name.
fn percent_encoded(name: &str) -> String {
    let encoded = |byte: u8| match byte {
        b'0'..=b'9' | b'A'..=b'Z' | b'a'..=b'z' | b'-' | b'.' | b'_' => char::from(byte).to_string(),
        _ => format!("%{byte:02X}"),
    };
    name.bytes().map(encoded).collect()
}

/// The head of a request, which stays in the stream: a WebSocket's is read once more by those who know them.
fn peeked(stream: &TcpStream) -> io::Result<Vec<u8>> {
    let mut bytes = vec![0; 16 << 10];
    let mut before = 0;
    for _ in 0..200 {
        let length = match stream.peek(&mut bytes) {
            Err(error) if error.kind() == io::ErrorKind::Interrupted => continue,
            length => length?,
        };
        if let Some(end) = bytes[..length].windows(4).position(|four| four == b"\r\n\r\n") {
            bytes.truncate(end + 4);
            return Ok(bytes);
        }
        if length == bytes.len() || length == 0 {
            break;
        }
        if length == before {
            // What was peeked is there at once the next time.
            thread::sleep(Duration::from_millis(5));
        }
        before = length;
    }
    Err(io::Error::new(io::ErrorKind::InvalidData, "not a request"))
}

/// Takes what was peeked.
fn consume(stream: &mut TcpStream, length: usize) -> io::Result<()> {
    io::Read::read_exact(stream, &mut vec![0; length])
}

#[cfg(test)]
mod tests {
    #[test]
    fn names_fit_into_a_header() {
        assert_eq!(super::percent_encoded("a b\r\né.fold"), "a%20b%0D%0A%C3%A9.fold");
    }
}
