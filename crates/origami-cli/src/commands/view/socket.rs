//! One page: its messages in, pictures out, and the sheet moving in between.

use std::io;
use std::net::TcpStream;
use std::time::{Duration, Instant};

use origami::session::{Packet, Reading, Request, Session};
use tungstenite::protocol::WebSocketConfig;
use tungstenite::{Error, Message, WebSocket};

use super::computer::Chosen;

/// A message may hold a pattern.
const MOST_BYTES: usize = 256 << 20;
/// How long the sheet moves between two looks at what the page says.
const SLICE: Duration = Duration::from_millis(4);
/// Steps that a slice is guessed to have at first, and at most.
const FIRST_STEPS: u64 = 8;
const MOST_STEPS: u64 = 4096;
/// Messages that are answered between two slices: whoever sends more waits.
const MOST_MESSAGES: usize = 64;
/// How long nothing may be heard: then it is asked whether somebody is there, and after as long again it ends.
const SILENCE: Duration = Duration::from_secs(30);

/// Answers a page until it leaves.
///
/// # Errors
/// What the system says.
pub(super) fn run(stream: TcpStream, computer: &Chosen, reading: &Reading) -> io::Result<()> {
    let config = WebSocketConfig::default().max_message_size(Some(MOST_BYTES)).max_frame_size(Some(MOST_BYTES));
    let Ok(socket) = tungstenite::accept_with_config(stream, Some(config)) else { return Ok(()) };
    let mut page = Page { socket, heard: Instant::now(), asked: false };
    let mut session = Session::new(Box::new(computer.clone())).reading(reading.clone());
    let mut steps = FIRST_STEPS;
    loop {
        for _ in 0..MOST_MESSAGES {
            // Where nothing moves there is time to wait.
            let message = if session.has_work() { page.look()? } else { page.wait()? };
            match message {
                Heard::Message(message) => {
                    for answer in answers(&mut session, message) {
                        page.send(&answer)?;
                    }
                    page.send_frame(&mut session)?;
                }
                Heard::Nothing => break,
                Heard::End => return Ok(()),
            }
        }
        if session.has_work() {
            let begun = Instant::now();
            session.advance(steps);
            let took = begun.elapsed();
            steps = if took > SLICE {
                (steps / 2).max(1)
            } else if took < SLICE / 2 {
                (2 * steps).min(MOST_STEPS)
            } else {
                steps
            };
        }
        page.send_frame(&mut session)?;
    }
}

fn answers(session: &mut Session, message: Message) -> Vec<Packet> {
    let packet = match message {
        Message::Text(text) => Ok(Packet { head: text.as_str().to_owned(), body: Vec::new() }),
        Message::Binary(bytes) => Packet::from_bytes(&bytes),
        _ => return Vec::new(),
    };
    match packet.and_then(|packet| packet.message::<Request>().map(|request| (request, packet.body))) {
        Ok((request, body)) => session.answer(request, &body),
        Err(malformed) => vec![Session::refusal(&malformed.to_string())],
    }
}

/// What came of listening.
enum Heard {
    Message(Message),
    Nothing,
    End,
}

/// The other side.
struct Page {
    socket: WebSocket<TcpStream>,
    heard: Instant,
    /// Whether it was asked if it is there.
    asked: bool,
}

impl Page {
    /// What has come, without waiting.
    fn look(&mut self) -> io::Result<Heard> {
        self.socket.get_ref().set_nonblocking(true)?;
        let heard = self.read();
        self.socket.get_ref().set_nonblocking(false)?;
        heard
    }

    /// What comes, for which it waits; a page that is silent for long is asked.
    fn wait(&mut self) -> io::Result<Heard> {
        self.socket.get_ref().set_read_timeout(Some(SILENCE))?;
        let heard = self.read()?;
        if matches!(heard, Heard::Nothing) {
            if self.asked && self.heard.elapsed() > 2 * SILENCE {
                return Ok(Heard::End);
            }
            self.asked = true;
            self.written(Message::Ping(Vec::new().into()))?;
        }
        Ok(heard)
    }

    fn read(&mut self) -> io::Result<Heard> {
        match self.socket.read() {
            Ok(Message::Close(_)) => Ok(Heard::End),
            Ok(message) => {
                (self.heard, self.asked) = (Instant::now(), false);
                Ok(Heard::Message(message))
            }
            Err(Error::Io(error)) if is_nothing(&error) => Ok(Heard::Nothing),
            Err(Error::Io(error)) => Err(error),
            Err(_) => Ok(Heard::End),
        }
    }

    /// Sends the picture that the page has asked for, where there is a new one.
    fn send_frame(&mut self, session: &mut Session) -> io::Result<()> {
        session.take_frame().map_or(Ok(()), |frame| self.send(&frame))
    }

    fn send(&mut self, packet: &Packet) -> io::Result<()> {
        self.written(Message::Binary(packet.to_bytes().into()))
    }

    fn written(&mut self, message: Message) -> io::Result<()> {
        let mut sent = self.socket.send(message);
        // What was not written before an interruption is still there.
        while matches!(&sent, Err(Error::Io(error)) if error.kind() == io::ErrorKind::Interrupted) {
            sent = self.socket.flush();
        }
        match sent {
            Ok(()) => Ok(()),
            Err(Error::Io(error)) => Err(error),
            Err(error) => Err(io::Error::other(error.to_string())),
        }
    }
}

/// Whether nothing has come: in time, or before a program that was stopped went on.
fn is_nothing(error: &io::Error) -> bool {
    matches!(error.kind(), io::ErrorKind::WouldBlock | io::ErrorKind::TimedOut | io::ErrorKind::Interrupted)
}
