//! The style of an element: its own properties and what it inherits.

use svgtypes::{Color, Number, NumberListParser, Paint};

use super::cascade::Declared;
use super::dashes::Dashes;

/// What a stroke is painted with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Ink<'a> {
    /// Nothing.
    None,
    /// One colour.
    Colour(Color),
    /// The property `color`.
    Current,
    /// A gradient, a pattern or what is no colour.
    Other(&'a str),
}

/// The properties that matter here, as they are for an element.
#[derive(Clone, Copy, Debug)]
pub(super) struct Style<'a> {
    pub(super) stroke: Ink<'a>,
    color: Color,
    stroke_opacity: f64,
    /// Of the element and all groups around it.
    opacity: f64,
    pub(super) visible: bool,
    pub(super) dashes: Dashes,
}

impl Default for Style<'_> {
    /// As it is around the root.
    fn default() -> Self {
        Self {
            stroke: Ink::None,
            color: Color::black(),
            stroke_opacity: 1.0,
            opacity: 1.0,
            visible: true,
            dashes: Dashes::Solid,
        }
    }
}

impl<'a> Style<'a> {
    /// The style of an element with these properties within one of this style.
    pub(super) fn within(mut self, own: &Declared<'a>) -> Self {
        let inherited = |value: &&str| *value != "inherit" && *value != "unset";
        if let Some(color) = own.color.filter(inherited) {
            self.color = color.parse().unwrap_or(self.color);
        }
        if let Some(stroke) = own.stroke.filter(inherited) {
            self.stroke = ink(stroke);
        }
        if let Some(value) = own.stroke_opacity.filter(inherited).and_then(share) {
            self.stroke_opacity = value;
        }
        self.opacity *= match own.opacity {
            // Opacity is not inherited unless that is asked for, and groups around multiply anyway.
            Some(value) => share(value).unwrap_or(1.0),
            None => 1.0,
        };
        if let Some(value) = own.visibility.filter(inherited) {
            self.visible = !matches!(value, "hidden" | "collapse");
        }
        if let Some(value) = own.dashes.filter(inherited) {
            let numbers: Result<Vec<f64>, _> = NumberListParser::from(value.replace("px", " ").as_str()).collect();
            self.dashes = numbers.map_or(Dashes::Solid, |lengths| Dashes::of(&lengths));
        }
        self
    }

    /// The colour of the stroke, if it is one.
    pub(super) fn colour(&self) -> Option<Color> {
        match self.stroke {
            Ink::Colour(colour) => Some(colour),
            Ink::Current => Some(self.color),
            Ink::None | Ink::Other(_) => None,
        }
    }

    /// How opaque a stroke of this colour is, from 0 to 1.
    pub(super) fn opacity(&self, colour: Color) -> f64 {
        self.opacity * self.stroke_opacity * f64::from(colour.alpha) / 255.0
    }
}

fn ink(value: &str) -> Ink<'_> {
    match Paint::from_str(value) {
        Ok(Paint::None) => Ink::None,
        Ok(Paint::Color(colour)) => Ink::Colour(colour),
        Ok(Paint::CurrentColor) => Ink::Current,
        _ if value.eq_ignore_ascii_case("currentcolor") => Ink::Current,
        _ => Ink::Other(value),
    }
}

/// An opacity, from 0 to 1.
fn share(value: &str) -> Option<f64> {
    let number = |text: &str| text.trim().parse::<Number>().ok().map(|number| number.0);
    let share = match value.strip_suffix('%') {
        Some(percent) => number(percent)? / 100.0,
        None => number(value)?,
    };
    share.is_finite().then(|| share.clamp(0.0, 1.0))
}
