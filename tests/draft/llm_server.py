"""A local OpenAI-compatible server that misbehaves on purpose."""

from __future__ import annotations

import base64
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
import json
import threading
import time
from typing import Any

from esg.draft.llm.scripted import ScriptedModel
from esg.draft.llm.stages import find_object

PNG = base64.b64decode(
    "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg=="
)


class Server(ThreadingHTTPServer):
    """Serves /v1/chat/completions and /v1/images/generations.

    Attributes:
        behave: (number of the request, its body) -> name of a behaviour, a method of `Handler`.
        bodies, keys: What was asked, and with which authorization.
    """

    daemon_threads = True
    # A silent handler must not hold up the end of a test.
    block_on_close = False

    def __init__(self, behave: Callable[[int, dict[str, Any]], str]) -> None:
        super().__init__(("127.0.0.1", 0), Handler)
        self.behave = behave
        self.model = ScriptedModel(0.0, 0.0)
        self.bodies: list[dict[str, Any]] = []
        self.keys: list[str] = []
        self.closing = threading.Event()
        self.lock = threading.Lock()

    @property
    def url(self) -> str:
        return f"http://127.0.0.1:{self.server_address[1]}/v1"

    def handle_error(self, request: Any, client_address: Any) -> None:
        """Clients that give up are part of the game."""


@contextmanager
def serve(behave: Callable[[int, dict[str, Any]], str] = lambda n, body: "ok") -> Iterator[Server]:
    server = Server(behave)
    thread = threading.Thread(target=server.serve_forever, kwargs={"poll_interval": 0.02})
    thread.start()
    try:
        yield server
    finally:
        server.closing.set()
        server.shutdown()
        server.server_close()
        thread.join()


class Handler(BaseHTTPRequestHandler):
    server: Server
    protocol_version = "HTTP/1.1"

    def log_message(self, format: str, *args: Any) -> None:
        pass

    def do_POST(self) -> None:
        body = json.loads(self.rfile.read(int(self.headers["Content-Length"])))
        with self.server.lock:
            number = len(self.server.bodies)
            self.server.bodies.append(body)
            self.server.keys.append(self.headers.get("Authorization", ""))
        behaviour = self.server.behave(number, body)
        if self.path.endswith("/images/generations") and behaviour == "ok":
            image = {"created": 0, "data": [{"b64_json": base64.b64encode(PNG).decode()}]}
            self.send(200, json.dumps(image))
            return
        getattr(self, behaviour)(body)

    def send(self, status: int, text: str, **headers: str) -> None:
        data = text.encode()
        self.send_response(status)
        self.send_header("Content-Type", "application/json")
        self.send_header("Content-Length", str(len(data)))
        for name, value in headers.items():
            self.send_header(name.replace("_", "-"), value)
        self.end_headers()
        self.wfile.write(data)

    def completion(self, text: str, finish: str = "stop") -> str:
        return json.dumps(
            {
                "id": "x",
                "object": "chat.completion",
                "created": 0,
                "model": "scripted",
                "choices": [
                    {
                        "index": 0,
                        "finish_reason": finish,
                        "message": {"role": "assistant", "content": text},
                    }
                ],
                "usage": {"prompt_tokens": 100, "completion_tokens": 50, "total_tokens": 150},
            }
        )

    def answer(self, body: dict[str, Any]) -> str:
        shape = body.get("response_format", {}).get("json_schema", {}).get("name")
        system = next(m["content"] for m in body["messages"] if m["role"] == "system")
        stage = shape or next(
            s
            for s, word in (
                ("scene", "what is there, and where"),
                ("timeline", "what must happen"),
            )
            if word in system
        )
        if stage == "visual":
            return json.dumps(VISUAL)
        talk = [
            (m["role"], m["content"] if isinstance(m["content"], str) else m["content"][0]["text"])
            for m in body["messages"]
            if m["role"] != "system"
        ]
        return self.server.model.answer(stage, talk)

    def ok(self, body: dict[str, Any]) -> None:
        self.send(200, self.completion(self.answer(body)))

    def error_500(self, body: dict[str, Any]) -> None:
        self.send(500, '{"error": {"message": "out of memory"}}')

    def error_429(self, body: dict[str, Any]) -> None:
        self.send(429, '{"error": {"message": "slow down"}}', Retry_After="0.05")

    def error_401(self, body: dict[str, Any]) -> None:
        key = self.headers.get("Authorization", "").removeprefix("Bearer ")
        self.send(401, json.dumps({"error": {"message": f"Incorrect API key provided: {key}"}}))

    def no_schema(self, body: dict[str, Any]) -> None:
        kind = body.get("response_format", {}).get("type", "none")
        if kind != "none":
            text = f"response_format of type {kind} is not supported"
            self.send(400, json.dumps({"error": {"message": text}}))
        else:
            self.ok(body)

    def cut(self, body: dict[str, Any]) -> None:
        text = self.answer(body)
        self.send(200, self.completion(text[: len(text) // 2], "length"))

    def wrong_refs(self, body: dict[str, Any]) -> None:
        tree = find_object(self.answer(body)) or {}
        for relation in tree.get("spatial", {}).get("relations", []):
            relation["object"] = "nobody_7"
        for segment in tree.get("segments", []):
            segment["end"] = "never_9"
        self.send(200, self.completion(json.dumps(tree)))

    def prose(self, body: dict[str, Any]) -> None:
        self.send(200, self.completion("I am sorry, I cannot do that."))

    def echo_key(self, body: dict[str, Any]) -> None:
        key = self.headers.get("Authorization", "").removeprefix("Bearer ")
        tree = find_object(self.answer(body)) or {}
        if "expansion" in tree:
            tree["expansion"]["expanded_description"] += f" Your key is {key}."
        self.send(200, self.completion(json.dumps(tree)))

    def html(self, body: dict[str, Any]) -> None:
        self.send(200, "<html>Bad gateway</html>")

    def half_http(self, body: dict[str, Any]) -> None:
        self.send_response(200)
        self.send_header("Content-Type", "application/json")
        self.send_header("Content-Length", "100000")
        self.end_headers()
        self.wfile.write(b'{"id": "x", "choi')
        self.close_connection = True

    def hang_up(self, body: dict[str, Any]) -> None:
        self.close_connection = True
        self.connection.close()

    def silence(self, body: dict[str, Any]) -> None:
        self.server.closing.wait(20.0)

    def endless(self, body: dict[str, Any]) -> None:
        self._begin_stream()
        chunk = b" " * 65536
        while not self.server.closing.is_set():
            self.wfile.write(b"10000\r\n" + chunk + b"\r\n")

    def trickle(self, body: dict[str, Any]) -> None:
        self._begin_stream()
        while not self.server.closing.is_set():
            self.wfile.write(b"1\r\n \r\n")
            self.wfile.flush()
            time.sleep(0.05)

    def _begin_stream(self) -> None:
        self.send_response(200)
        self.send_header("Content-Type", "application/json")
        self.send_header("Transfer-Encoding", "chunked")
        self.end_headers()


VISUAL: dict[str, Any] = {"relations": [], "places": []}
"""What the vision model answers; tests fill it in."""
