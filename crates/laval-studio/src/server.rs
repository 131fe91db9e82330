//! The server: its address, its state, its beginning and its end.

use crate::machines::Machines;
use crate::runs::Runs;
use crate::{Options, folder, routes};
use axum::serve::ListenerExt;
use laval::diagnostic::Diagnostic;
use laval::text;
use std::io;
use std::net::{Ipv4Addr, SocketAddr, TcpListener};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;
use tokio::sync::Notify;

/// Characters of a token, from 16 random bytes.
const HEX: &[u8; 16] = b"0123456789abcdef";
/// Time that computations have for ending once the server ends.
const GRACE: Duration = Duration::from_secs(2);
/// Most computations at once; more wait.
const COMPUTATIONS: usize = 16;

/// What all requests share.
pub(crate) struct State {
    pub options: Options,
    pub token: String,
    pub port: u16,
    pub machines: Machines,
    pub runs: Runs,
    /// The text that the page checked last.
    pub shown: Mutex<Option<String>>,
}

/// A server that listens.
pub struct Server {
    listener: TcpListener,
    state: Arc<State>,
    stop: Arc<Notify>,
}

/// Ends a server.
#[derive(Clone)]
pub struct Handle {
    stop: Arc<Notify>,
    state: Arc<State>,
}

impl Handle {
    /// The text of the page, with all that was changed there; none before the page was opened.
    pub fn text(&self) -> Option<String> {
        self.state.shown.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }

    /// Ends the server; long studies keep what they have computed.
    pub fn stop(&self) {
        self.state.runs.stop();
        self.stop.notify_one();
    }
}

fn failed(e: &io::Error) -> Diagnostic {
    Diagnostic::error("studio.listen", text!("the server cannot be started: {e}", e = e.to_string()))
}

/// 128 random bits.
fn random() -> io::Result<String> {
    let mut bytes = [0; 16];
    getrandom::fill(&mut bytes).map_err(|e| io::Error::other(e.to_string()))?;
    Ok(bytes.iter().flat_map(|b| [HEX[usize::from(b >> 4)], HEX[usize::from(b & 15)]]).map(char::from).collect())
}

impl Server {
    /// Listens on the loopback address.
    ///
    /// # Errors
    /// A port that is taken, a token that cannot stand in an address, a folder that does not exist.
    pub fn new(mut options: Options) -> Result<Server, Diagnostic> {
        let token = match options.token.take() {
            Some(token) => token,
            None => random().map_err(|e| failed(&e))?,
        };
        if token.len() < 8 || !token.bytes().all(|b| b.is_ascii_alphanumeric()) {
            return Err(Diagnostic::error("studio.token", text!("a token has at least 8 letters and digits")));
        }
        options.folder = options.folder.canonicalize().map_err(|e| {
            Diagnostic::error("studio.folder", text!("cannot open {path}: {e}", path = options.folder.display(), e = e.to_string()))
        })?;
        if let Some(file) = options.file.as_ref().filter(|f| f.exists() && options.text.is_none()) {
            let name = folder::name_of(&options.folder, file)
                .ok_or_else(|| Diagnostic::error("studio.file", text!("{path} is a link out of its folder", path = file.display())))?;
            folder::read(&options.folder, &name)?;
        }
        let address = SocketAddr::from((Ipv4Addr::LOCALHOST, options.port));
        let listener = TcpListener::bind(address).map_err(|e| match e.kind() {
            io::ErrorKind::AddrInUse | io::ErrorKind::PermissionDenied => {
                let message = text!("port {port} cannot be used: {e}", port = options.port, e = e.to_string());
                Diagnostic::error("studio.port", message).help(text!("give another port, or leave --port out: a free one is taken"))
            }
            _ => failed(&e),
        })?;
        listener.set_nonblocking(true).map_err(|e| failed(&e))?;
        let port = listener.local_addr().map_err(|e| failed(&e))?.port();
        let runs = Runs::new(options.folder.clone(), options.file.clone());
        let state = State { options, token, port, machines: Machines::default(), runs, shown: Mutex::default() };
        Ok(Server { listener, state: Arc::new(state), stop: Arc::default() })
    }

    /// The address of the page.
    pub fn address(&self) -> String {
        format!("http://127.0.0.1:{}/{}/", self.state.port, self.state.token)
    }

    /// Ends this server from another thread.
    pub fn handle(&self) -> Handle {
        Handle { stop: self.stop.clone(), state: self.state.clone() }
    }

    /// Serves until it is ended.
    ///
    /// # Errors
    /// When the system does not let it.
    pub fn serve(self) -> Result<(), Diagnostic> {
        let runtime = tokio::runtime::Builder::new_current_thread()
            .enable_io()
            .enable_time()
            .max_blocking_threads(COMPUTATIONS)
            .build()
            .map_err(|e| failed(&e))?;
        let Server { listener, state, stop } = self;
        let served = runtime.block_on(async {
            let listener = tokio::net::TcpListener::from_std(listener)?;
            // an answer is a few small pieces: without this the last waits for the acknowledgement of those before
            let listener = listener.tap_io(|stream| {
                let _ = stream.set_nodelay(true);
            });
            let app = routes::routes(state.clone());
            tokio::select! {
                done = std::future::IntoFuture::into_future(axum::serve(listener, app)) => done,
                () = stop.notified() => Ok(()),
            }
        });
        // connections that are dropped abandon their computations
        runtime.shutdown_timeout(GRACE);
        state.runs.finish();
        served.map_err(|e| failed(&e))
    }
}
