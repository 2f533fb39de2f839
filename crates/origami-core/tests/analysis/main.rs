//! Structural analysis against closed forms, and against what MERLIN and Sim-FAST computed.
//!
//! `cases` has structures of those programs' examples: nodes, members, supports and loads as numbers, without units as they
//! have none (Sim-FAST's in m and N), and what the programs found. Lines and then apexes of hinges, interior angles from 0
//! to a full turn, as they have them.

mod case;
mod designs;
mod gradients;
mod jobs;
mod kresling;
mod merlin;
mod miura;
mod paths;
mod states;
