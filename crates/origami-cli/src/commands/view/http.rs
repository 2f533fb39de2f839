//! As much of HTTP as one page needs: the head of a request, and answers.

use std::io::{self, BufRead, BufReader, Read, Write};
use std::net::TcpStream;

/// Bytes that the head of a request may have.
const MOST_HEAD: u64 = 16 << 10;

/// What is asked for.
#[derive(Debug, Default, PartialEq, Eq)]
pub(super) struct Head {
    pub(super) method: String,
    pub(super) path: String,
    /// Names in lower case.
    fields: Vec<(String, String)>,
}

impl Head {
    /// Reads the head from a stream, without what comes after it where the stream is a copy that was peeked.
    ///
    /// # Errors
    /// What the system says, or that this is no HTTP.
    pub(super) fn read(stream: impl Read) -> io::Result<Self> {
        let odd = || io::Error::new(io::ErrorKind::InvalidData, "not a request");
        let mut lines = BufReader::new(stream.take(MOST_HEAD)).lines();
        let first = lines.next().ok_or_else(odd)??;
        let mut words = first.split(' ');
        let (Some(method), Some(path), Some("HTTP/1.1" | "HTTP/1.0"), None) =
            (words.next(), words.next(), words.next(), words.next())
        else {
            return Err(odd());
        };
        let mut head = Self { method: method.to_owned(), path: path.to_owned(), fields: Vec::new() };
        for line in lines {
            let line = line?;
            if line.is_empty() {
                return Ok(head);
            }
            let (name, value) = line.split_once(':').ok_or_else(odd)?;
            head.fields.push((name.to_ascii_lowercase(), value.trim().to_owned()));
        }
        // It ended, or is longer than a page's.
        Err(odd())
    }

    /// The one field of a name; `None` where there is none, or more than one.
    pub(super) fn field(&self, name: &str) -> Option<&str> {
        let mut values = self.fields.iter().filter(|(known, _)| known == name).map(|(_, value)| value.as_str());
        values.next().filter(|_| values.next().is_none())
    }

    /// Whether it was sent to this machine by its own name. A page elsewhere that has made its name lead here is not.
    pub(super) fn is_local(&self) -> bool {
        let Some(host) = self.field("host") else { return false };
        let name =
            host.rsplit_once(':').filter(|(_, port)| port.bytes().all(|b| b.is_ascii_digit())).map_or(host, |(n, _)| n);
        matches!(name, "127.0.0.1" | "localhost" | "[::1]")
    }

    /// Whether a page of this server asks; one that does not say who it is cannot be a page.
    pub(super) fn is_own(&self) -> bool {
        match (self.field("origin"), self.field("host")) {
            (Some(origin), Some(host)) => origin.strip_prefix("http://") == Some(host),
            _ => false,
        }
    }
}

/// Answers with a text or a file.
///
/// # Errors
/// What the system says.
pub(super) fn answer(
    stream: &mut TcpStream,
    status: &str,
    media: &str,
    host: &str,
    more: &[(&str, &str)],
    body: &[u8],
) -> io::Result<()> {
    // A page from here runs and loads only what comes from here.
    let policy = format!(
        "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self'; img-src 'self' data: blob:; \
         connect-src 'self' ws://{host}; worker-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
    );
    let mut head = format!(
        "HTTP/1.1 {status}\r\nContent-Type: {media}\r\nContent-Length: {}\r\nContent-Security-Policy: {policy}\r\n\
         X-Content-Type-Options: nosniff\r\nCross-Origin-Resource-Policy: same-origin\r\nReferrer-Policy: no-referrer\r\n\
         Cache-Control: no-store\r\nConnection: close\r\n",
        body.len()
    );
    for (name, value) in more {
        head += &format!("{name}: {value}\r\n");
    }
    head += "\r\n";
    stream.write_all(head.as_bytes())?;
    stream.write_all(body)?;
    stream.flush()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn head(text: &str) -> io::Result<Head> {
        Head::read(text.as_bytes())
    }

    #[test]
    fn only_this_machine_by_its_own_name() {
        let local =
            |host: &str| head(&format!("GET / HTTP/1.1\r\nHost: {host}\r\n\r\n")).is_ok_and(|head| head.is_local());
        assert!(local("127.0.0.1:81") && local("localhost:81") && local("localhost") && local("[::1]:81"));
        assert!(!local("example.org") && !local("127.0.0.1.example.org:81") && !local("localhost:81:81") && !local(""));
        assert!(!head("GET / HTTP/1.1\r\nHost: localhost\r\nHost: localhost\r\n\r\n").expect("a head").is_local());
    }

    #[test]
    fn only_pages_of_its_own() {
        let own = |origin: &str| {
            let text = format!("GET / HTTP/1.1\r\nHost: 127.0.0.1:81\r\n{origin}\r\n");
            head(&text).is_ok_and(|head| head.is_own())
        };
        assert!(own("Origin: http://127.0.0.1:81\r\n"));
        assert!(!own("") && !own("Origin: null\r\n") && !own("Origin: http://127.0.0.1:82\r\n"));
        assert!(!own("Origin: https://127.0.0.1:81\r\n") && !own("Origin: http://example.org\r\n"));
    }

    #[test]
    fn what_is_no_request_is_refused() {
        for text in [
            "",
            "\r\n",
            "GET /\r\n\r\n",
            "GET / HTTP/2\r\n\r\n",
            "GET / HTTP/1.1\r\nHost\r\n\r\n",
            "GET / HTTP/1.1\r\n",
        ] {
            assert!(head(text).is_err(), "{text:?}");
        }
        let long = format!("GET / HTTP/1.1\r\nA: {}\r\n\r\n", "a".repeat(20 << 10));
        assert!(head(&long).is_err());
    }
}
