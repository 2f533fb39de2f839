//! What only those know who were given the address.

/// 32 hexadecimal digits from the system's source of randomness.
///
/// # Errors
/// That there is none.
pub(super) fn secret() -> Result<String, String> {
    let mut bytes = [0; 16];
    getrandom::fill(&mut bytes).map_err(|error| format!("the system gives no random numbers: {error}"))?;
    Ok(bytes.iter().map(|byte| format!("{byte:02x}")).collect())
}

/// Whether both are the same, in a time that does not tell how much of them is.
pub(super) fn same(one: &str, other: &str) -> bool {
    one.len() == other.len() && one.bytes().zip(other.bytes()).fold(0, |differ, (a, b)| differ | (a ^ b)) == 0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn secrets_differ_and_are_told_apart() {
        let (one, other) = (secret().expect("random numbers"), secret().expect("random numbers"));
        assert!(one.len() == 32 && !same(&one, &other) && same(&one, &one.clone()));
        assert!(!same(&one, &one[1..]) && !same("", &one));
    }
}
