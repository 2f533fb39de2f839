//! Creases: the second derivatives of the fold angle. R. Tamstorf and E. Grinspun, Discrete bending forces and their
//! Jacobians, Graphical Models 75 (2013), have them by heights and cotangents; here they are derived from the gradient in
//! the frame of each triangle.
//!
//! The angle depends on `a_i = p_i - p3` and `e = p4 - p3` alone. On one side of the crease let u be its unit direction,
//! t that from it to the apex, n the normal, so that the apex lies at `a = s e + h t` with the foot s and the height h,
//! and the gradient is `n / h` for a. Moving a along t changes h, moving it along n turns n towards -t; moving e along t
//! moves the crease by s of that below the apex, moving it along n turns n by it over |e| about t and by s of it over h
//! about u. With `S = n t^T + t n^T` that is
//!
//! ```text
//! d2/da^2 = -S/h^2        d2/da de = s S/h^2 - u n^T/(h |e|)
//! d2/de^2 = -(1/(2 |e|^2) + s^2/h^2) S + s/(h |e|) (u n^T + n u^T)     summed over both sides
//! ```
//!
//! and nothing between the two apexes. The angle does not change when all move together, which gives the rest.

use glam::{DMat3, DVec3};

use super::{both, outer};
use crate::forces::creases;

/// A hinge in one position, and how its fold angle changes as its nodes move.
#[derive(Clone, Copy, Debug)]
pub struct Hinge {
    /// `dtheta/dp`, for nodes 1 to 4, in radians per radius of the sheet.
    pub gradient: [DVec3; 4],
    /// `d2theta / dp_i dp_j`: `second[i][j]` has the components of node i + 1 in its rows.
    pub second: [[DMat3; 4]; 4],
}

/// The hinge of four points; `None` where a triangle beside it is too thin for its angle to mean anything.
#[must_use]
pub fn hinge(points: [DVec3; 4]) -> Option<Hinge> {
    let gradient = creases::hinge(points)?.gradient;
    let [p1, p2, p3, p4] = points;
    let e = p4 - p3;
    let length = e.length();
    let u = e / length;
    let sides = [side(p1 - p3, u, length, gradient[0]), side(p2 - p3, u, length, gradient[1])];

    let [of_1, of_2] = [sides[0].apex, sides[1].apex];
    let [of_14, of_24] = [sides[0].apex_and_crease, sides[1].apex_and_crease];
    let of_4 = sides[0].crease + sides[1].crease;
    // Those with node 3 are minus the sums of the others.
    let [of_13, of_23, of_43] = [-(of_1 + of_14), -(of_2 + of_24), -(of_14 + of_24 + of_4).transpose()];
    let of_3 = -(of_13 + of_23 + of_43);
    let second = [
        [of_1, DMat3::ZERO, of_13, of_14],
        [DMat3::ZERO, of_2, of_23, of_24],
        [of_13.transpose(), of_23.transpose(), of_3, of_43.transpose()],
        [of_14.transpose(), of_24.transpose(), of_43, of_4],
    ];
    Some(Hinge { gradient, second })
}

/// What one triangle has of the derivatives by its apex and by the crease.
struct Side {
    apex: DMat3,
    apex_and_crease: DMat3,
    crease: DMat3,
}

fn side(a: DVec3, u: DVec3, length: f64, gradient: DVec3) -> Side {
    let along = a.dot(u);
    let across = a - u * along;
    let h = across.length();
    let (t, n, s) = (across / h, gradient * h, along / length);
    let sym = both(n, t);
    Side {
        apex: sym * -h.powi(-2),
        apex_and_crease: sym * (s / (h * h)) - outer(u, n) * (h * length).recip(),
        crease: sym * -(0.5 / (length * length) + (s / h).powi(2)) + both(u, n) * (s / (h * length)),
    }
}
