//! A folding as one packet, for a page that has no solver behind it: what a session would have said of each state.
//!
//! Positions are whole numbers of 16 bits between the ends of the box that all states lie in, so that a vertex is off by less
//! than one part in 100 000 of the sheet; the strain of each node is 8 bits of the largest there is. Both are written as
//! differences from what the frames before let expect, which packs well.

use origami_core::measure::node_strains;
use origami_core::solve::Folded;
use origami_core::{CreasePattern, Model};
use serde::Serialize;

use crate::message::{Crossed, FrameHead, MapWish, Opened, Recorded, Wishes};
use crate::numbers::{head, report};
use crate::packet::Packet;
use crate::sheet::{Named, described};

/// What a film says before its numbers.
#[derive(Serialize)]
#[serde(tag = "is", rename = "film")]
struct Head {
    opened: Opened,
    frames: Vec<FrameHead>,
    /// The corner of the box, in radii, and its longest side divided by 65535.
    low: [f64; 3],
    unit: f64,
    /// The strain that 255 stands for.
    strain: f64,
}

/// The film of a sheet that goes through `states`, of which each is drawn where it is. The body has what the reply `opened` has,
/// and for each state low bytes and high bytes of x, y and z of all nodes, then a byte of strain of each.
///
/// `name` is the file's, `title` the one that the page shows; `labels` are what states are called, where they are. States that do not
/// go from percentage to percentage are counted by how much of the way has gone, which is 100 long.
#[must_use]
pub fn film(
    (name, title): (&str, Option<String>),
    pattern: &CreasePattern,
    model: &Model,
    states: &[Folded],
    labels: &[String],
) -> Packet {
    let named = Named { name: name.to_owned(), format: "film".to_owned(), title };
    let (opened, mut body) = described(&named, pattern, model, &Wishes::default(), String::new());
    let percents = percents(states);
    let frames = states.iter().zip(&percents).enumerate().map(|(number, (folded, percent))| {
        let wanted = folded.targets.of(model).unwrap_or_default();
        let (mut head, _) = head(model, &folded.state, &wanted, report(folded), MapWish::None);
        head.percent = *percent;
        head.crossings = Some(Crossed::of(model, &folded.state.positions));
        head.recorded = labels.get(number).map(|label| Recorded {
            at: f64::from(u32::try_from(number).unwrap_or(u32::MAX)),
            states: states.len(),
            of: states.len(),
            label: label.clone(),
            ended: None,
        });
        head
    });
    let frames: Vec<FrameHead> = frames.collect();
    let [mut low, mut high] = [f64::INFINITY, f64::NEG_INFINITY].map(origami_core::glam::DVec3::splat);
    for position in states.iter().flat_map(|folded| &folded.state.positions) {
        (low, high) = (low.min(*position), high.max(*position));
    }
    let unit = ((high - low).max_element() / 65_535.0).max(f64::MIN_POSITIVE);
    let strains: Vec<Vec<f64>> = states.iter().map(|folded| node_strains(model, &folded.state.positions)).collect();
    let strain = strains.iter().flatten().copied().fold(f64::MIN_POSITIVE, f64::max);

    let mut before: [Vec<u16>; 2] = [Vec::new(), Vec::new()];
    let mut strain_before = vec![0_u8; model.node_count()];
    for (folded, strains) in states.iter().zip(&strains) {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to 65535 by the box")]
        let whole = |x: f64| (x / unit).round().clamp(0.0, 65_535.0) as u16;
        let now: Vec<u16> =
            folded.state.positions.iter().flat_map(|position| (*position - low).to_array().map(whole)).collect();
        let residuals: Vec<u16> = (0..now.len()).map(|i| now[i].wrapping_sub(expected(&now, &before, i))).collect();
        body.extend(residuals.iter().map(|residual| zigzag(*residual).to_le_bytes()[0]));
        body.extend(residuals.iter().map(|residual| zigzag(*residual).to_le_bytes()[1]));
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to 255 by the largest")]
        let of_nodes: Vec<u8> = strains.iter().map(|own| (own / strain * 255.0).round() as u8).collect();
        body.extend(of_nodes.iter().zip(&strain_before).map(|(now, before)| now.wrapping_sub(*before)));
        strain_before = of_nodes;
        let [last, _] = before;
        before = [now, last];
    }
    Packet::new(&Head { opened, frames, low: low.to_array(), unit, strain }, body)
}

/// How far each state is folded: the percentages, where each is farther on than the one before it; else shares of the way.
fn percents(states: &[Folded]) -> Vec<f64> {
    let percents: Vec<f64> = states.iter().filter_map(Folded::percent).collect();
    let rising = |by: f64| percents.windows(2).all(|two| by * (two[1] - two[0]) > 0.0);
    if percents.len() == states.len() && (rising(1.0) || rising(-1.0)) {
        return percents;
    }
    #[expect(clippy::cast_precision_loss, reason = "some thousands")]
    let share = |i: usize| 100.0 * i as f64 / states.len().saturating_sub(1).max(1) as f64;
    (0..states.len()).map(share).collect()
}

/// Number `i` of a frame, by those before it: as it went on in the last two frames, as it was in the last, or as the node
/// before it is.
fn expected(now: &[u16], [last, before_last]: &[Vec<u16>; 2], i: usize) -> u16 {
    match (last.get(i), before_last.get(i)) {
        (Some(last), Some(before_last)) => last.wrapping_mul(2).wrapping_sub(*before_last),
        (Some(last), None) => *last,
        _ => i.checked_sub(3).map_or(0, |node_before| now[node_before]),
    }
}

/// Small differences of either sign as small numbers.
fn zigzag(difference: u16) -> u16 {
    (difference << 1) ^ if difference & 0x8000 == 0 { 0 } else { 0xffff }
}

#[cfg(test)]
mod tests {
    use super::*;
    use origami_core::generate::BirdBase;
    use origami_core::solve::{Relax, State, fold_path, unwatched};
    use origami_core::{Material, glam::DVec3};

    /// As the page reads it.
    fn read(packet: &Packet, model: &Model, edges: usize, frames: usize) -> Vec<Vec<DVec3>> {
        let head: serde_json::Value = serde_json::from_str(&packet.head).expect("JSON");
        let number = |value: &serde_json::Value| value.as_f64().expect("a number");
        let low: Vec<f64> = head["low"].as_array().expect("three").iter().map(number).collect();
        let count = 3 * model.node_count();
        let mut at = 4 * (count + 4 * model.mesh.triangles.len() + 3 * edges);
        let mut before: [Vec<u16>; 2] = [Vec::new(), Vec::new()];
        let mut states = Vec::new();
        for _ in 0..frames {
            let mut now: Vec<u16> = Vec::new();
            for i in 0..count {
                let zigzag = u16::from_le_bytes([packet.body[at + i], packet.body[at + count + i]]);
                let difference = (zigzag >> 1) ^ (zigzag & 1).wrapping_neg();
                now.push(expected(&now, &before, i).wrapping_add(difference));
            }
            at += 2 * count + model.node_count();
            let places = now.chunks_exact(3).map(|whole| {
                let place = |k: usize| low[k] + f64::from(whole[k]) * number(&head["unit"]);
                DVec3::new(place(0), place(1), place(2))
            });
            states.push(places.collect());
            let [last, _] = before;
            before = [now, last];
        }
        assert_eq!(at, packet.body.len());
        states
    }

    #[test]
    fn what_is_read_is_what_was_written() {
        let pattern = BirdBase::default().pattern().expect("the default");
        let model = Model::new(&pattern, &Material::default()).expect("a sheet");
        let percents = [0.0, 30.0, 60.0, 90.0, 100.0];
        let states =
            fold_path(&model, &Relax::default(), &percents, &mut |_, progress| unwatched(progress)).expect("folds");
        let packet = film(("bird", None), &pattern, &model, &states, &[]);
        let read = read(&packet, &model, pattern.edges.len(), states.len());
        let apart = |state: &State, read: &[DVec3]| {
            state.positions.iter().zip(read).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max)
        };
        let most = states.iter().zip(&read).map(|(folded, read)| apart(&folded.state, read)).fold(0.0, f64::max);
        assert!(most < 3e-5, "{most}");
        // The test can fail: other states are elsewhere.
        assert!(apart(&states[1].state, &read[2]) > 0.01);
    }

    #[test]
    fn what_goes_back_is_counted_by_the_way() {
        let pattern = BirdBase::default().pattern().expect("the default");
        let model = Model::new(&pattern, &Material::default()).expect("a sheet");
        let counted = |wanted: &[f64]| {
            let states = fold_path(&model, &Relax::default(), wanted, &mut |_, progress| unwatched(progress));
            percents(&states.expect("folds"))
        };
        assert_eq!(counted(&[0.0, 10.0, 40.0]), [0.0, 10.0, 40.0]);
        assert_eq!(counted(&[20.0, 10.0]), [20.0, 10.0]);
        assert_eq!(counted(&[0.0, 20.0, 10.0]), [0.0, 50.0, 100.0]);
        assert_eq!(counted(&[10.0]), [10.0]);
    }
}
