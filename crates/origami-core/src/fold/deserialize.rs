//! How each kind of value is parsed, straight into its vector. Every message says what was expected.

use std::borrow::Cow;
use std::fmt;

use glam::DVec3;
use serde::de::{DeserializeSeed, Deserializer, Error, IgnoredAny, MapAccess, SeqAccess, Unexpected, Visitor};
use serde_json::{Map, Number, Value};

use super::Coordinates;

/// Makes a visitor its own seed.
macro_rules! seed {
    ($name:ident => $value:ty, $method:ident) => {
        impl<'de> DeserializeSeed<'de> for $name {
            type Value = $value;

            fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<$value, D::Error> {
                deserializer.$method(self)
            }
        }
    };
}

/// An array of what `item` parses; `expected` names it in messages.
#[derive(Clone, Copy)]
pub(super) struct Items<S> {
    pub(super) expected: &'static str,
    pub(super) item: S,
}

impl<'de, S: DeserializeSeed<'de> + Copy> DeserializeSeed<'de> for Items<S> {
    type Value = Vec<S::Value>;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Self::Value, D::Error> {
        deserializer.deserialize_seq(self)
    }
}

impl<'de, S: DeserializeSeed<'de> + Copy> Visitor<'de> for Items<S> {
    type Value = Vec<S::Value>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.expected)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut array: A) -> Result<Self::Value, A::Error> {
        let mut items = Vec::new();
        while let Some(item) = array.next_element_seed(self.item)? {
            items.push(item);
        }
        Ok(items)
    }
}

/// `null` or what the seed parses.
#[derive(Clone, Copy)]
pub(super) struct Optional<S>(pub(super) S);

impl<'de, S: DeserializeSeed<'de>> DeserializeSeed<'de> for Optional<S> {
    type Value = Option<S::Value>;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Self::Value, D::Error> {
        deserializer.deserialize_option(self)
    }
}

impl<'de, S: DeserializeSeed<'de>> Visitor<'de> for Optional<S> {
    type Value = Option<S::Value>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a value or null")
    }

    fn visit_none<E: Error>(self) -> Result<Self::Value, E> {
        Ok(None)
    }

    fn visit_unit<E: Error>(self) -> Result<Self::Value, E> {
        Ok(None)
    }

    fn visit_some<D: Deserializer<'de>>(self, deserializer: D) -> Result<Self::Value, D::Error> {
        self.0.deserialize(deserializer).map(Some)
    }
}

/// An index into another array. `3.0` is 3, as it is in JavaScript.
#[derive(Clone, Copy)]
pub(super) struct Index;

seed!(Index => u32, deserialize_u32);

impl Visitor<'_> for Index {
    type Value = u32;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "an index, a whole number from 0 to {}", u32::MAX)
    }

    fn visit_u64<E: Error>(self, value: u64) -> Result<u32, E> {
        u32::try_from(value).map_err(|_| E::invalid_value(Unexpected::Unsigned(value), &self))
    }

    fn visit_i64<E: Error>(self, value: i64) -> Result<u32, E> {
        u32::try_from(value).map_err(|_| E::invalid_value(Unexpected::Signed(value), &self))
    }

    fn visit_f64<E: Error>(self, value: f64) -> Result<u32, E> {
        let index = value as u32;
        if f64::from(index) == value { Ok(index) } else { Err(E::invalid_value(Unexpected::Float(value), &self)) }
    }
}

/// The two ends of an edge.
#[derive(Clone, Copy)]
pub(super) struct Pair;

seed!(Pair => [u32; 2], deserialize_seq);

impl<'de> Visitor<'de> for Pair {
    type Value = [u32; 2];

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("two vertex indices")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut array: A) -> Result<[u32; 2], A::Error> {
        let mut pair = [0; 2];
        for (length, end) in pair.iter_mut().enumerate() {
            *end = array.next_element_seed(Index)?.ok_or_else(|| A::Error::invalid_length(length, &self))?;
        }
        match array.next_element::<IgnoredAny>()? {
            None => Ok(pair),
            Some(_) => Err(A::Error::custom("more than two numbers, expected two vertex indices")),
        }
    }
}

/// A letter, or whatever stands in its place.
#[derive(Clone, Copy)]
pub(super) struct Letter;

seed!(Letter => Cow<'static, str>, deserialize_str);

impl Visitor<'_> for Letter {
    type Value = Cow<'static, str>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a string")
    }

    fn visit_str<E: Error>(self, value: &str) -> Result<Self::Value, E> {
        const LETTERS: [&str; 7] = ["B", "M", "V", "F", "U", "C", "J"];
        let known = LETTERS.into_iter().find(|letter| *letter == value);
        Ok(known.map_or_else(|| Cow::Owned(value.to_owned()), Cow::Borrowed))
    }
}

/// The position of a vertex.
#[derive(Clone, Copy)]
pub(super) struct Point;

seed!(Point => Coordinates, deserialize_seq);

impl<'de> Visitor<'de> for Point {
    type Value = Coordinates;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("two or three coordinates")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut array: A) -> Result<Coordinates, A::Error> {
        let mut numbers = [0.0; 3];
        let mut count = 0;
        while let Some(number) = array.next_element_seed(Finite)? {
            match numbers.get_mut(count) {
                Some(slot) => *slot = number,
                None if number == 0.0 => {}
                None => return Err(A::Error::custom("not 0 beyond the third coordinate, expected at most x, y and z")),
            }
            count += 1;
        }
        match count {
            0 | 1 => Err(A::Error::invalid_length(count, &self)),
            2 => Ok(Coordinates { position: DVec3::from_array(numbers), dimension: 2 }),
            _ => Ok(Coordinates { position: DVec3::from_array(numbers), dimension: 3 }),
        }
    }
}

/// A number; JSON has no others than finite ones.
#[derive(Clone, Copy)]
pub(super) struct Finite;

seed!(Finite => f64, deserialize_f64);

impl Visitor<'_> for Finite {
    type Value = f64;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a number")
    }

    fn visit_u64<E: Error>(self, value: u64) -> Result<f64, E> {
        Ok(value as f64)
    }

    fn visit_i64<E: Error>(self, value: i64) -> Result<f64, E> {
        Ok(value as f64)
    }

    fn visit_f64<E: Error>(self, value: f64) -> Result<f64, E> {
        if value.is_finite() { Ok(value) } else { Err(E::invalid_value(Unexpected::Float(value), &self)) }
    }
}

/// Any value. Unlike `Value`'s own parser it refuses an object with the same key twice.
#[derive(Clone, Copy)]
pub(super) struct Any;

seed!(Any => Value, deserialize_any);

impl<'de> Visitor<'de> for Any {
    type Value = Value;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a JSON value")
    }

    fn visit_unit<E: Error>(self) -> Result<Value, E> {
        Ok(Value::Null)
    }

    fn visit_bool<E: Error>(self, value: bool) -> Result<Value, E> {
        Ok(Value::Bool(value))
    }

    fn visit_u64<E: Error>(self, value: u64) -> Result<Value, E> {
        Ok(Value::from(value))
    }

    fn visit_i64<E: Error>(self, value: i64) -> Result<Value, E> {
        Ok(Value::from(value))
    }

    fn visit_f64<E: Error>(self, value: f64) -> Result<Value, E> {
        Number::from_f64(value).map(Value::Number).ok_or_else(|| E::invalid_value(Unexpected::Float(value), &Finite))
    }

    fn visit_str<E: Error>(self, value: &str) -> Result<Value, E> {
        Ok(Value::from(value))
    }

    fn visit_string<E: Error>(self, value: String) -> Result<Value, E> {
        Ok(Value::String(value))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, array: A) -> Result<Value, A::Error> {
        Items { expected: "an array", item: Any }.visit_seq(array).map(Value::Array)
    }

    fn visit_map<A: MapAccess<'de>>(self, mut object: A) -> Result<Value, A::Error> {
        let mut map = Map::new();
        while let Some(key) = object.next_key::<String>()? {
            if map.contains_key(&key) {
                object.next_value_seed(Twice)?;
            }
            let value = object.next_value_seed(Any)?;
            map.insert(key, value);
        }
        Ok(Value::Object(map))
    }
}

/// The message for a key that an object has twice.
pub(super) const KEY_TWICE: &str = "the key is there twice in one object, expected once";

/// The value of a key that the object has already. Refused here, where the path of keys still names it.
#[derive(Clone, Copy)]
pub(super) struct Twice;

impl<'de> DeserializeSeed<'de> for Twice {
    type Value = ();

    fn deserialize<D: Deserializer<'de>>(self, _: D) -> Result<(), D::Error> {
        Err(D::Error::custom(KEY_TWICE))
    }
}
