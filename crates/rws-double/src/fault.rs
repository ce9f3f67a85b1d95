//! What can go wrong on purpose, request by request.

use crate::controller::Controller;

/// A request as a plan of faults sees it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RequestSeen {
    /// Which request it is, from 0.
    pub number: usize,
    /// Method of HTTP: `GET`, `POST`, ...
    pub method: String,
    /// Path and query of the request.
    pub uri: String,
}

/// A fault that the double commits on purpose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Fault {
    /// Answers 503 and does nothing.
    Unavailable,
    /// The connection ends before anything is done.
    DropBefore,
    /// It is done, and the connection ends without an answer.
    DropAfter,
    /// It is done, and half of the answer comes.
    CutBody,
    /// It is done, and after the head nothing comes for so many milliseconds; then the connection ends.
    Stall(u64),
    /// All comes, so many milliseconds later.
    Delay(u64),
    /// It is done, and the answer brings cookies of nobody's session.
    WrongCookies,
    /// The session is forgotten before the request.
    SessionLost,
    /// 200, and the answer says that it failed; nothing is done.
    ErrorInside,
    /// It is done, and the answer is JSON that is none.
    BrokenText,
    /// Of a file, half is kept, and the connection ends.
    HalfFile,
    /// Done, and answered as text of another kind.
    WrongType,
    /// The mode is changed by the key before the request.
    ModeTurned(&'static str),
    /// The pendant takes the right to write before the request.
    PendantTakes,
    /// The program is started at the pendant before the request.
    Started,
    /// The controller restarts before the request: no session, no nonce, no right.
    Restart,
    /// The word for the state of execution is an unknown one.
    UnknownExecution,
    /// The next page of the list is the list itself.
    LoopingNext,
}

/// Decides for each request which fault it meets; it may change the controller as well.
pub type Plan = Box<dyn FnMut(&RequestSeen, &mut Controller) -> Option<Fault> + Send>;
