"""The studio's server: it answers on this machine alone, sends its own files, and nothing else."""

import gzip
import http.client
import json
import os
import re
import signal
import socket
import subprocess
import sys
import threading
import zlib
from base64 import urlsafe_b64decode
from collections.abc import Iterator
from http.client import HTTPResponse
from pathlib import Path

import pytest
from test_cli import shell

import carom
from carom.studio import built, fragment_of
from carom.studio.server import Server

POLICY = "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'"
PAGE = f"""<!doctype html>
<meta
  http-equiv="Content-Security-Policy"
  content="{POLICY}"
/>
<title>The page</title>
"""
SECRET = "not for anyone"


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A small page, with things around it that are none of a page."""
    page = tmp_path / "page"
    (page / "assets").mkdir(parents=True)
    (page / "index.html").write_text(PAGE, encoding="utf-8")
    (page / "assets" / "worker-a_1.js").write_text("postMessage(1);" * 100, encoding="utf-8")
    (page / "assets" / "style.css").write_text("* { margin: 0 }", encoding="utf-8")
    (page / "assets" / "engine.wasm").write_bytes(b"\0asm")
    (tmp_path / "secret.txt").write_text(SECRET, encoding="utf-8")
    monkeypatch.setattr(built, "PAGE", page)
    return page


@pytest.fixture
def server(folder: Path) -> Iterator[Server]:
    with Server(fragment="#scenario=abc") as served:
        threading.Thread(target=served.serve_forever, args=(0.01,), daemon=True).start()
        yield served
        served.shutdown()


def ask(server: Server, path: str, method: str = "GET", **headers: str) -> tuple[HTTPResponse, bytes]:
    connection = http.client.HTTPConnection("127.0.0.1", server.server_port, timeout=10)
    connection.request(method, path, headers=headers)
    answer = connection.getresponse()
    content = answer.read()
    connection.close()
    return answer, content


def raw(server: Server, text: str) -> bytes:
    """Send bytes as they are: clients tidy up paths."""
    with socket.create_connection(("127.0.0.1", server.server_port), timeout=10) as connection:
        connection.sendall(text.encode("latin-1"))
        connection.shutdown(socket.SHUT_WR)
        return b"".join(iter(lambda: connection.recv(65536), b""))


def test_it_is_bound_to_the_loopback_address(server: Server) -> None:
    assert server.socket.getsockname()[0] == "127.0.0.1"
    assert server.address == f"http://127.0.0.1:{server.server_port}/"


@pytest.mark.parametrize(
    ("path", "kind"),
    [
        ("/", "text/html; charset=utf-8"),
        ("/?embed", "text/html; charset=utf-8"),
        ("/index.html", "text/html; charset=utf-8"),
        ("/assets/worker-a_1.js", "text/javascript; charset=utf-8"),
        ("/assets/style.css", "text/css; charset=utf-8"),
        ("/assets/engine.wasm", "application/wasm"),
    ],
)
def test_files_come_with_their_types_and_a_strict_policy(server: Server, folder: Path, path: str, kind: str) -> None:
    answer, content = ask(server, path)
    name = path.partition("?")[0].lstrip("/") or "index.html"
    assert (answer.status, content) == (200, (folder / name).read_bytes())
    assert answer.headers["Content-Type"] == kind
    assert answer.headers["Content-Security-Policy"] == f"{POLICY}; frame-ancestors 'none'"
    assert answer.headers["X-Content-Type-Options"] == "nosniff"
    assert answer.headers["Referrer-Policy"] == "no-referrer"
    assert answer.headers["Cross-Origin-Opener-Policy"] == "same-origin"
    assert answer.headers["Content-Encoding"] is None


def test_it_packs_for_those_who_take_it(server: Server, folder: Path) -> None:
    plain = (folder / "assets" / "worker-a_1.js").read_bytes()
    answer, content = ask(server, "/assets/worker-a_1.js", **{"Accept-Encoding": "br;q=0, gzip;q=0.8"})
    assert answer.headers["Content-Encoding"] == "gzip"
    assert (len(content) < len(plain), gzip.decompress(content)) == (True, plain)
    answer, content = ask(server, "/assets/worker-a_1.js", **{"Accept-Encoding": "gzip;q=0"})
    assert (answer.headers["Content-Encoding"], content) == (None, plain)


def test_a_head_has_no_body(server: Server) -> None:
    answer, content = ask(server, "/", "HEAD")
    assert (answer.status, answer.headers["Content-Length"], content) == (200, str(len(PAGE)), b"")


@pytest.mark.parametrize(
    "path",
    [
        "/../secret.txt",
        "/assets/../../secret.txt",
        "/%2e%2e/secret.txt",
        "/..%2fsecret.txt",
        "/%252e%252e/secret.txt",
        "/..\\secret.txt",
        "/assets/..%5c..%5csecret.txt",
        "//secret.txt",
        "/./index.html",
        "/assets",
        "/assets/",
        "/page/index.html",
        "../secret.txt",
        "http://127.0.0.1/../secret.txt",
        "file:///etc/passwd",
        "/etc/passwd",
        "//[",
        "/index.html%00.txt",
    ],
)
def test_no_path_leads_out_of_the_page(server: Server, folder: Path, path: str) -> None:
    absolute = str(folder.parent / "secret.txt")
    for asked in (path, absolute):
        host = f"127.0.0.1:{server.server_port}"
        answer = raw(server, f"GET {asked} HTTP/1.1\r\nHost: {host}\r\nConnection: close\r\n\r\n")
        assert re.match(rb"HTTP/1\.1 40[04] ", answer), answer
        assert SECRET.encode() not in answer


@pytest.mark.skipif(sys.platform == "win32", reason="links need rights there")
def test_links_out_of_the_page_are_not_followed(folder: Path) -> None:
    (folder / "assets" / "secret.txt").symlink_to(folder.parent / "secret.txt")
    (folder / "out").symlink_to(folder.parent, target_is_directory=True)
    with Server() as server:
        assert set(server.files) == {
            "/",
            "/index.html",
            "/assets/worker-a_1.js",
            "/assets/style.css",
            "/assets/engine.wasm",
        }


@pytest.mark.parametrize("host", ["evil.example", "evil.example:{port}", "127.0.0.1", "localhost.evil.example:{port}"])
def test_a_name_of_elsewhere_that_leads_here_is_refused(server: Server, host: str) -> None:
    answer, content = ask(server, "/", Host=host.format(port=server.server_port))
    assert (answer.status, b"The page" in content) == (403, False)
    assert ask(server, "/", Host=f"localhost:{server.server_port}")[0].status == 200


def test_it_takes_nothing(server: Server) -> None:
    for method in ("POST", "PUT", "DELETE"):
        assert ask(server, "/", method)[0].status == 501


def test_a_long_link_is_led_on_to(server: Server) -> None:
    answer, _ = ask(server, "/scenario")
    assert (answer.status, answer.headers["Location"]) == (303, "/#scenario=abc")


# The link


def unpacked(fragment: str) -> tuple[dict[str, object], dict[str, object]]:
    packed = urlsafe_b64decode(fragment.removeprefix("#scenario=") + "==")
    head, _, scenario = zlib.decompress(packed, -zlib.MAX_WBITS).decode("utf-8").partition("\n")
    return json.loads(head), json.loads(scenario)


def test_a_link_holds_the_whole_scenario_with_its_digest(midterm: carom.Scenario, run: carom.Run) -> None:
    fragment = fragment_of(midterm, run.digest)
    assert re.fullmatch(r"#scenario=[\w-]+", fragment)
    head, scenario = unpacked(fragment)
    assert head == {"format": 1, "physics_version": carom.PHYSICS_VERSION, "digest": run.digest}
    assert scenario == midterm.to_dict()


# The command


@pytest.fixture
def opened(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """The addresses that a browser is asked to open; the server ends at once, as by Ctrl-C."""
    found: list[str] = []
    told = threading.Event()

    def open_(link: str) -> None:
        found.append(link)
        told.set()

    def interrupted(*_: object) -> None:
        told.wait(10)
        raise KeyboardInterrupt

    monkeypatch.setattr("webbrowser.open", open_)
    monkeypatch.setattr(Server, "serve_forever", interrupted)
    return found


@pytest.mark.usefixtures("folder")
def test_the_browser_opens_with_the_scenario(opened: list[str], tmp_path: Path, midterm: carom.Scenario) -> None:
    mine = tmp_path / "mine.toml"
    midterm.save(mine)
    for words in ([], ["midterm"], [mine]):
        done = shell("studio", *words)
        assert (done.code, done.stderr) == (0, "")
        assert opened[-1] in done.stdout
    nothing, named, whole = (link.partition("/#")[2] for link in opened)
    assert (nothing, named) == ("", "midterm")
    assert unpacked(f"#{whole}")[1] == midterm.to_dict()


@pytest.mark.usefixtures("folder")
def test_a_large_scenario_is_opened_by_a_short_address(opened: list[str], tmp_path: Path) -> None:
    balls = [carom.Ball(f"b{k}", radius=0.1, position=(1 + k % 20 + 1 / (k + 3), 1 + k // 20)) for k in range(200)]
    carom.Scenario(carom.Table.rectangle(width=22, length=22), balls, duration=1).save(tmp_path / "many.json")
    assert shell("studio", tmp_path / "many.json").code == 0
    assert opened[0].endswith("/scenario")


@pytest.mark.usefixtures("folder")
def test_what_cannot_be_served_is_said(opened: list[str]) -> None:
    wrong = shell("studio", "midtrem")
    assert (wrong.code, wrong.stderr.count("\n")) == (1, 1)
    assert "midterm" in wrong.stderr
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        port = taken.getsockname()[1]
        wrong = shell("studio", "--port", port)
    assert (wrong.code, wrong.stderr.startswith(f"error: --port: {port} ")) == (1, True)
    assert opened == []


def test_without_a_page_it_is_said_how_to_get_it(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(built, "PAGE", tmp_path / "none")
    done = shell("studio")
    assert (done.code, done.stdout, done.stderr.count("\n")) == (1, "", 1)
    assert "make package-page" in done.stderr


@pytest.mark.skipif(sys.platform == "win32", reason="Ctrl-C is sent as a signal")
@pytest.mark.skipif(not built.PAGE.exists(), reason="the page is not built")
def test_ctrl_c_ends_it_cleanly() -> None:
    command = [sys.executable, "-m", "carom", "studio", "--no-browser"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as served:
        assert served.stdout is not None
        address = served.stdout.readline().split()[-1]
        port = int(address.rstrip("/").rpartition(":")[2])
        with socket.create_connection(("127.0.0.1", port), timeout=10):  # one who stays does not hold it up
            os.kill(served.pid, signal.SIGINT)
            _, errors = served.communicate(timeout=20)
    assert (served.returncode, errors) == (0, "")
