//! What may be asked at all. Everything else could move the robot, change it or restart it, and is a hit.
//!
//! A list of what is allowed, by method, path and action, written from the documents and not from the client.

use crate::Personality;

/// A request without its host.
#[derive(Clone, Copy, Debug)]
pub struct RequestParts<'a> {
    /// Method of HTTP: `GET`, `POST`, ...
    pub method: &'a str,
    /// Decoded, without the query.
    pub path: &'a str,
    /// Parameters of the query.
    pub query: &'a [(String, String)],
    /// Fields of a form; none for a file.
    pub form: &'a [(String, String)],
}

impl RequestParts<'_> {
    fn value<'v>(pairs: &'v [(String, String)], name: &str) -> Option<&'v str> {
        pairs.iter().find(|(n, _)| n == name).map(|(_, v)| v.as_str())
    }
}

/// Paths that are read; `*` is one part, a last `**` one or more.
const READ: [&str; 30] = [
    "/rw/system",
    "/rw/system/options",
    "/rw/system/robottype",
    "/ctrl/identity",
    "/users/grants",
    "/uas/user/grants",
    "/rw/panel/opmode",
    "/rw/panel/ctrlstate",
    "/rw/panel/ctrl-state",
    "/rw/rapid/execution",
    "/rw/rapid/tasks",
    "/rw/rapid/tasks/*/modules",
    "/rw/rapid/modules",
    "/rw/rapid/symbol/data/RAPID/*/*/*",
    "/rw/rapid/symbol/properties/RAPID/*/*/*",
    "/rw/rapid/symbol/RAPID/*/*/*/data",
    "/rw/rapid/symbol/RAPID/*/*/*/properties",
    "/rw/motionsystem",
    "/rw/motionsystem/mechunits/*/jointtarget",
    "/rw/motionsystem/mechunits/*/robtarget",
    "/rw/retcode",
    "/rw/mastership/*",
    "/rw/controlstation/writeaccess/status",
    "/users/rmmp/poll",
    "/poll/*",
    "/logout",
    "/fileservice",
    "/fileservice/**",
    "/rw/devices/SW_RESOURCES",
    "/rw/devices/SW_RESOURCES/**",
];

/// What is posted: the dialect (6, or 7 for 7 and 8, 8 for 8 alone), path, and the action in the query of 6.
const POSTED: [(u8, &str, &str); 23] = [
    (6, "/rw/motionsystem/mechunits/*", "CalcPoseFromJoints"),
    (6, "/rw/motionsystem/mechunits/*", "JointsFromCartesian"),
    (6, "/rw/motionsystem/mechunits/*", "AllJointSolutions"),
    (7, "/rw/motionsystem/mechunits/*/pose-from-joints", ""),
    (7, "/rw/motionsystem/mechunits/*/joints-from-cartesian", ""),
    (7, "/rw/motionsystem/mechunits/*/all-joints-solution", ""),
    (6, "/rw/rapid/symbol/data/RAPID/*/*/*", "set"),
    (7, "/rw/rapid/symbol/RAPID/*/*/*/data", ""),
    (6, "/rw/rapid/tasks/*", "loadmod"),
    (7, "/rw/rapid/tasks/*/loadmod", ""),
    (6, "/rw/rapid/tasks/*", "unloadmod"),
    (7, "/rw/rapid/tasks/*/unloadmod", ""),
    (6, "/rw/mastership/rapid", "request"),
    (6, "/rw/mastership/rapid", "release"),
    (7, "/rw/mastership/edit/request", ""),
    (7, "/rw/mastership/edit/release", ""),
    (8, "/rw/controlstation/writeaccess/request", ""),
    (8, "/rw/controlstation/writeaccess/release", ""),
    (8, "/rw/controlstation/register/remote", ""),
    (0, "/users/rmmp", ""),
    (6, "/users/rmmp", "cancel"),
    (7, "/users/rmmp/cancel", ""),
    (0, "/subscription", ""),
];

/// Whether a request is one of those that can do no harm.
///
/// # Errors
/// What is wrong with it.
pub fn judge(personality: Personality, asked: &RequestParts<'_>) -> Result<(), String> {
    let hit = |why: &str| Err(format!("{} {}: {why}", asked.method, asked.path));
    if asked.path.split('/').any(|part| part == "..") {
        return hit("it climbs out of its folder");
    }
    match asked.method {
        "GET" if RequestParts::value(asked.query, "action").is_some() => hit("an action by GET"),
        "GET" if READ.iter().any(|form| is_like(asked.path, form)) => Ok(()),
        "POST" => posted(personality, asked),
        "PUT" => match file_in_home(asked.path) {
            true => Ok(()),
            false => hit("a file elsewhere than directly in HOME, or no module"),
        },
        "DELETE" if is_like(asked.path, "/subscription/*") => Ok(()),
        _ => hit("it is not on the list of harmless requests"),
    }
}

fn posted(personality: Personality, asked: &RequestParts<'_>) -> Result<(), String> {
    let hit = |why: &str| Err(format!("POST {}: {why}", asked.path));
    let action = RequestParts::value(asked.query, "action").unwrap_or_default();
    let of_dialect = |dialect: u8| match personality {
        Personality::Rw6 => dialect == 6 || dialect == 0,
        Personality::Rw7 => dialect == 7 || dialect == 0,
        Personality::Rw8 => dialect != 6,
    };
    let is_known = POSTED
        .iter()
        .any(|(dialect, form, of)| of_dialect(*dialect) && is_like(asked.path, form) && *of == action);
    if !is_known {
        return hit(&format!("it is not on the list of harmless requests (action \"{action}\")"));
    }
    if asked.query.iter().any(|(name, _)| name != "action") {
        return hit("a parameter that is not expected");
    }
    let field = |name: &str| RequestParts::value(asked.form, name);
    if asked.path == "/users/rmmp" && action.is_empty() && field("privilege") != Some("modify") {
        return hit("a privilege beyond writing");
    }
    if let Some(path) = field("modulepath")
        && !file_in_home(&format!("/fileservice/{path}"))
    {
        return hit("a module from elsewhere than HOME");
    }
    if field("replace").is_some_and(|replace| replace != "false") {
        return hit("it replaces a module whoever made it");
    }
    Ok(())
}

/// A module directly in HOME.
fn file_in_home(path: &str) -> bool {
    let name = ["/fileservice/$HOME/", "/fileservice/HOME/"].iter().find_map(|home| path.strip_prefix(home));
    let ends = [".mod", ".modx", ".sys", ".sysx", ".prg"];
    name.is_some_and(|name| {
        let lower = name.to_ascii_lowercase();
        !name.contains(['/', '\\', ':'])
            && !name.starts_with('.')
            && ends.iter().any(|end| lower.ends_with(end))
    })
}

fn is_like(path: &str, form: &str) -> bool {
    let (mut parts, mut forms) = (path.split('/'), form.split('/'));
    loop {
        match (parts.next(), forms.next()) {
            (None, None) => return true,
            (Some(part), Some("**")) => return !part.is_empty(),
            (Some(part), Some("*")) if !part.is_empty() => {}
            (Some(part), Some(form)) if part == form => {}
            _ => return false,
        }
    }
}
