//! `origami view`: a page that folds.

#[cfg(not(feature = "view"))]
mod absent;
#[cfg(feature = "view")]
mod browser;
#[cfg(feature = "view")]
mod computer;
#[cfg(feature = "view")]
mod http;
#[cfg(feature = "view")]
mod present;
#[cfg(feature = "view")]
mod secret;
#[cfg(feature = "view")]
mod server;
#[cfg(feature = "view")]
mod socket;

#[cfg(not(feature = "view"))]
pub(super) use absent::run;
#[cfg(feature = "view")]
pub(super) use present::run;
