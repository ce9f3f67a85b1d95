//! Subscriptions: groups of data, and the websocket that tells of their changes.

use crate::Personality;
use crate::controller::Controller;
use crate::groups::Group;
use crate::http::{Incoming, Line, Reply};
use crate::resources::{Rejection, found};
use crate::world::{Shared, World};
use std::io;
use std::time::Duration;
use tungstenite::handshake::derive_accept_key;
use tungstenite::protocol::frame::coding::CloseCode;
use tungstenite::protocol::{CloseFrame, Role};
use tungstenite::{Message, WebSocket};

/// Task, module and name of what is subscribed to; the path of the other dialect is none.
fn subject(personality: Personality, uri: &str) -> Option<[String; 3]> {
    let path = uri.strip_suffix(";value")?;
    let parts: Vec<&str> = path.split('/').skip(1).collect();
    let found = match (personality, parts.as_slice()) {
        (Personality::Rw6, ["rw", "rapid", "symbol", "data", "RAPID", task, module, name]) => {
            [task, module, name]
        }
        (
            Personality::Rw7 | Personality::Rw8,
            ["rw", "rapid", "symbol", "RAPID", task, module, name, "data"],
        ) => [task, module, name],
        _ => return None,
    };
    Some(found.map(|part| (*part).to_owned()))
}

pub(crate) fn subscribe(world: &mut World, request: &Incoming, session: u64) -> Result<Reply, Rejection> {
    let c = &world.controller;
    if !c.offers_subscriptions {
        return Err((404, -1_073_445_861, "feature off"));
    }
    let wrong = match c.personality {
        Personality::Rw7 => (500, -1_073_414_145, "unexpected"),
        _ => (400, -1_073_445_866, "URL not resolved"),
    };
    let form = request.form();
    let mut data = Vec::new();
    for (_, number) in form.iter().filter(|(name, _)| name == "resources") {
        let uri = form.iter().find(|(name, _)| name == number).map(|(_, uri)| uri.as_str()).ok_or(wrong)?;
        let priority = form.iter().find(|(name, _)| *name == format!("{number}-p")).map(|(_, p)| p.as_str());
        if !matches!(priority, Some("0" | "1" | "2")) {
            return Err(wrong);
        }
        let subject = subject(c.personality, uri).ok_or(wrong)?;
        let (declared, _) = found(c, &subject[0], &subject[1], &subject[2])?;
        if declared.kind != "per" {
            return Err((400, -1_073_442_786, "symbol is not persistent"));
        }
        data.push(subject);
    }
    if data.is_empty() {
        return Err(wrong);
    }
    world.groups.made += 1;
    let number = world.groups.made.to_string();
    let host =
        if c.foreign_location { "192.168.125.1" } else { request.header("host").unwrap_or("localhost") };
    let scheme = if c.personality.is_tls() { "wss" } else { "ws" };
    let location = format!("{scheme}://{host}/poll/{number}");
    world.groups.open.insert(number, Group { session, data, is_polled: false });
    Ok(Reply::new(201).with("Location", location))
}

/// Opens the websocket of a group; its address is good once.
pub(crate) fn upgrade(world: &mut World, request: &Incoming, session: u64) -> Reply {
    let wanted = match world.controller.personality {
        Personality::Rw6 => "robapi2_subscription",
        _ => "rws_subscription",
    };
    let number = request.parts().last().copied().unwrap_or_default();
    let Some(group) = world.groups.open.get_mut(number).filter(|g| g.session == session && !g.is_polled)
    else {
        return Reply::new(404);
    };
    let (Some(key), Some(protocol)) =
        (request.header("sec-websocket-key"), request.header("sec-websocket-protocol"))
    else {
        return Reply::new(400);
    };
    if protocol != wanted {
        return Reply::new(400);
    }
    group.is_polled = true;
    Reply::new(101)
        .with("Upgrade", "websocket")
        .with("Connection", "Upgrade")
        .with("Sec-WebSocket-Accept", derive_accept_key(key.as_bytes()))
        .with("Sec-WebSocket-Protocol", wanted)
}

fn values(c: &Controller, data: &[[String; 3]]) -> Vec<Option<String>> {
    data.iter().map(|[_, module, name]| c.value(module, name)).collect()
}

/// Tells of changes until either side ends it; ends the group with it.
pub(crate) fn serve(line: Line, shared: &Shared, request: &Incoming, number: &str) {
    let _ = line.tcp().set_read_timeout(Some(Duration::from_millis(20)));
    let personality = shared.lock().controller.personality;
    let mut socket: WebSocket<Line> = WebSocket::from_raw_socket(line, Role::Server, None);
    let mut last: Option<Vec<Option<String>>> = None;
    while !shared.is_stopped() {
        let (data, now) = {
            let mut world = shared.lock();
            let is_session = world.sessions.of(request).is_some();
            let Some(group) = world.groups.open.get(number).filter(|_| is_session) else { break };
            (group.data.clone(), values(&world.controller, &group.data))
        };
        for (i, value) in now.iter().enumerate() {
            let is_new = last.as_ref().is_none_or(|last| last[i] != *value);
            if is_new && socket.send(Message::text(event(personality, &data[i]))).is_err() {
                break;
            }
        }
        last = Some(now);
        match socket.read() {
            // RobotWare 7 and 8 take no word of the client.
            Ok(Message::Close(_)) => break,
            Ok(_) if personality != Personality::Rw6 => {
                let _ =
                    socket.close(Some(CloseFrame { code: CloseCode::Policy, reason: "no frames".into() }));
                let _ = socket.flush();
                break;
            }
            Ok(_) => {}
            Err(tungstenite::Error::Io(e))
                if matches!(e.kind(), io::ErrorKind::WouldBlock | io::ErrorKind::TimedOut) => {}
            Err(_) => break,
        }
    }
    shared.lock().groups.open.remove(number);
    socket.get_ref().cut();
}

fn event(personality: Personality, [task, module, name]: &[String; 3]) -> String {
    let uri = match personality {
        Personality::Rw6 => format!("/rw/rapid/symbol/data/RAPID/{task}/{module}/{name};value"),
        _ => format!("/rw/rapid/symbol/RAPID/{task}/{module}/{name}/data;value"),
    };
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?><html xmlns=\"http://www.w3.org/1999/xhtml\"><body><div class=\"state\"><ul>\
         <li class=\"rap-value-ev\" title=\"value\"><a href=\"{uri}\" rel=\"self\"/></li></ul></div></body></html>"
    )
}
