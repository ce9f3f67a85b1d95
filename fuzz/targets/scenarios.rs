//! Any scenario is read or refused.

use virtual_controller::Scenario;

/// A scenario of `simulate`: its steps or an error.
pub fn scenarios(data: &[u8]) {
    let Ok(text) = std::str::from_utf8(data) else { return };
    if let Ok(scenario) = Scenario::from_toml(text) {
        assert!(scenario.signals().all(|name| !name.is_empty()), "a signal without a name");
    }
}
