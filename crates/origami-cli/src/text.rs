//! Text from outside, as a person may be shown it: names, titles and letters say what they say and steer no terminal.

use std::borrow::Cow;

/// Characters of a title or the like that a line still holds.
const BRIEF: usize = 200;

/// Without characters that would steer a terminal or turn the order of what is read: they are shown as `\n`, `\u{1b}`.
pub(crate) fn plain(text: &str) -> Cow<'_, str> {
    if !text.contains(steers) {
        return Cow::Borrowed(text);
    }
    let mut shown = String::with_capacity(text.len() + 16);
    for c in text.chars() {
        if steers(c) {
            shown.extend(c.escape_default());
        } else {
            shown.push(c);
        }
    }
    Cow::Owned(shown)
}

/// The same of many lines.
pub(crate) fn plain_lines(text: &str) -> Cow<'_, str> {
    if !text.contains(|c| c != '\n' && steers(c)) {
        return Cow::Borrowed(text);
    }
    Cow::Owned(text.split('\n').map(plain).collect::<Vec<_>>().join("\n"))
}

/// As much of a text as a line holds, plain; what is left out is counted.
pub(crate) fn brief(text: &str) -> String {
    match text.char_indices().nth(BRIEF) {
        None => plain(text).into_owned(),
        Some((end, _)) => {
            let rest = crate::numbers::grouped(text[end..].chars().count() as u64);
            format!("{}... and {rest} more characters", plain(&text[..end]))
        }
    }
}

/// Control characters, line and paragraph separators, and those that turn the direction of writing.
fn steers(c: char) -> bool {
    c.is_control()
        || matches!(c, '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{206f}' | '\u{feff}')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_steers_is_shown_and_does_nothing() {
        let cases = [
            ("crane, Kranich, 鶴", "crane, Kranich, 鶴"),
            ("\u{1b}[31mred", "\\u{1b}[31mred"),
            ("two\nlines\tand a tab", "two\\nlines\\tand a tab"),
            ("\u{9b}2J", "\\u{9b}2J"),
            ("a\u{202e}dlof.", "a\\u{202e}dlof."),
            ("\u{2066}a\u{2069}\u{200f}", "\\u{2066}a\\u{2069}\\u{200f}"),
        ];
        for (text, shown) in cases {
            assert_eq!(plain(text), shown);
            assert_eq!(
                plain_lines(&format!("{text}\nb")),
                format!("{}\nb", text.split('\n').map(plain).collect::<Vec<_>>().join("\n"))
            );
        }
    }

    #[test]
    fn long_texts_are_cut_between_characters() {
        assert_eq!(brief("short"), "short");
        let long = brief(&"鶴".repeat(1300));
        assert_eq!(long, format!("{}... and 1 100 more characters", "鶴".repeat(200)));
    }
}
