//! Time of one step of [`Dynamics`] on the CPU: triangulated Miura sheets of 100 to 100 000 nodes, one thread, f64.
//! Criterion prints the throughput in nodes times steps per second; its inverse is the time per node and step.
fn main() {}
