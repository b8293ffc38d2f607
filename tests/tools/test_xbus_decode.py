# SPDX-License-Identifier: MIT
"""./run xbus-decode: what it says of recordings that are made here, byte by byte."""

from __future__ import annotations

import json
import math
import os
import random
import struct
import subprocess
from pathlib import Path
from typing import Any

import pytest

RECORDINGS = Path(__file__).parents[1] / "data" / "xbus"


def decode(file: Path, *options: str) -> subprocess.CompletedProcess[str]:
    program = Path(os.environ["DISMOUNT_BUILD"]) / "xbus" / "xbus_decode"
    return subprocess.run([program, file, *options], capture_output=True, text=True, check=False)


def report(file: Path, *options: str) -> dict[str, Any]:
    done = decode(file, "--json", *options)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


def message(bus_id: int, mid: int, data: bytes = b"") -> bytes:
    size = len(data)
    length = bytes([size]) if size < 255 else b"\xff" + struct.pack(">H", size)
    body = bytes([bus_id, mid]) + length + data
    return b"\xfa" + body + bytes([-sum(body) & 0xFF])


def quaternion(rng: random.Random) -> list[float]:
    parts = [rng.gauss(0, 1) for _ in range(4)]
    norm = math.sqrt(sum(part * part for part in parts))
    return [part / norm for part in parts]


def configuration(trackers: int, mode: int, settings: int) -> bytes:
    head = struct.pack(">IHHHHI", 0x00100042, 1152, 0, 0, 0, 0) + b"2008013112304500" + bytes(64)
    block = b"".join(
        struct.pack(">IHHIH6s", 0x00300001 + i, 16, mode, settings, 0, bytes(6))
        for i in range(trackers)
    )
    return message(0xFF, 0x0D, head + struct.pack(">H", trackers) + block)


def suit_data(rng: random.Random, counter: int, trackers: int) -> tuple[bytes, list[list[float]]]:
    turns = [quaternion(rng) for _ in range(trackers)]
    data = struct.pack(">H", counter & 0xFFFF) + b"".join(struct.pack(">4f", *q) for q in turns)
    return message(0xFF, 0x32, data), turns


def as_floats(values: list[float]) -> list[float]:
    return list(struct.unpack(f">{len(values)}f", struct.pack(f">{len(values)}f", *values)))


def test_a_suit_is_told_by_its_configuration(tmp_path: Path) -> None:
    rng = random.Random(1)
    sent = [suit_data(rng, 65530 + i, 17) for i in range(20)]
    file = tmp_path / "suit.bin"
    lost = sent[:5] + sent[8:]
    error = message(0xFF, 0x42, b"\x1e\x03")
    file.write_bytes(
        message(0xFF, 0x3E) + configuration(17, 4, 0) + error + b"".join(b for b, _ in lost)
    )
    found = report(file)
    assert found["malformed_bytes"] == 0
    assert found["message_counts"] == {"Configuration": 1, "Error": 1, "MTData": 17, "WakeUp": 1}
    assert found["formats"][0]["source"] == "Configuration"
    devices = {device["bus_id"]: device for device in found["devices"]}
    assert devices[3]["received"] == 17
    assert devices[3]["lost"] == 3
    assert devices[3]["device_id"] == "0x00300003"
    assert devices[3]["rate_hz"] == pytest.approx(100.0)
    assert devices[255]["kind"] == "Xbus Master"
    data = [entry for entry in found["messages"] if entry["name"] == "MTData"]
    for entry, (_, turns) in zip(data, lost, strict=True):
        assert [s["quaternion"] for s in entry["samples"]] == [as_floats(q) for q in turns]
        assert entry["samples"][0]["axes"] == "NWU"
    fault = next(entry for entry in found["messages"] if entry["name"] == "Error")
    assert (fault["code"], fault["faulty_bus_id"]) == (0x1E, 3)
    assert found["messages"][1]["trackers"][16]["device_id"] == "0x00300011"


def test_a_suit_is_told_by_what_the_host_set(tmp_path: Path) -> None:
    rng = random.Random(2)
    file = tmp_path / "suit.bin"
    ids = struct.pack(">3I", 0x00300001, 0x00300002, 0x00300003)
    setting = b"".join(
        message(k, 0xD0, b"\x00\x04") + message(k, 0xD1) + message(k, 0xD2, bytes(4))
        for k in (1, 2, 3)
    )
    data = b"".join(suit_data(rng, i, 3)[0] for i in range(10))
    file.write_bytes(message(0xFF, 0x03, ids) + setting + data)
    found = report(file)
    assert found["undecoded_messages"] == 0
    assert found["formats"][-1] == {
        "source": "SetOutputMode",
        "master": True,
        "data_length": 50,
        "trackers": [{"mode": 4, "settings": 0}] * 3,
    }
    assert found["items"]["quaternion"]["count"] == 30


def test_a_format_is_guessed_or_asked_for(tmp_path: Path) -> None:
    rng = random.Random(3)
    file = tmp_path / "suit.bin"
    file.write_bytes(b"".join(suit_data(rng, i, 15)[0] for i in range(30)))
    found = report(file)
    assert found["formats"][0]["source"] == "guess"
    assert len(found["formats"][0]["trackers"]) == 15
    assert "a guess" in decode(file).stdout
    file.write_bytes(b"".join(message(0xFF, 0x32, bytes([i] * 23)) for i in range(5)))
    odd = report(file)
    assert odd["undecoded_messages"] == 5
    assert odd["messages"][1]["data"] == "01" * 23
    assert "--mode=" in decode(file).stdout
    # Twenty bytes as the raw data of a tracker, and its counter.
    file.write_bytes(b"".join(message(0xFF, 0x32, bytes(20) + bytes([0, i])) for i in range(5)))
    raw = report(file, "--mode=0x4000", "--settings=1")
    assert raw["messages"][4]["samples"][0]["counter"] == 4
    assert raw["messages"][4]["samples"][0]["raw_temperature"] == 0


@pytest.mark.parametrize("name", ["1", "2", "3"])
def test_recordings_are_told_in_full(name: str) -> None:
    found = report(RECORDINGS / name / "output.bin")
    assert found["frames"] == 100
    assert found["malformed_bytes"] == 0
    assert found["unknown_items"] == 0
    device = found["devices"][0]
    assert (device["received"], device["lost"]) == (100, 0)
    assert device["rate_hz"] == pytest.approx(100.0, abs=0.5)
    golden = (RECORDINGS / name / "output.golden").read_text(encoding="utf-8")
    for entry, text in zip(found["messages"], golden.strip().split("\n\n"), strict=True):
        heads = [line for line in text.split("\n") if line and not line.startswith(" ")]
        names = [head.partition("(")[0].rstrip(":") for head in heads]
        assert [item["name"] for item in entry["items"]] == names


def test_clean_messages_survive_damage(tmp_path: Path) -> None:
    rng = random.Random(4)
    sent = [suit_data(rng, i, 15)[0] for i in range(4000)]
    stream = bytearray(configuration(15, 4, 0) + b"".join(sent))
    begin = len(stream) - sum(map(len, sent))
    touched = set()
    for at in range(begin, len(stream)):
        if rng.random() < 1e-3:
            stream[at] ^= rng.randrange(1, 256)
            touched.add((at - begin) // len(sent[0]))
    file = tmp_path / "noisy.bin"
    file.write_bytes(stream)
    found = report(file)
    taken = {entry["offset"] for entry in found["messages"] if entry["name"] == "MTData"}
    clean = {begin + i * len(sent[0]) for i in range(len(sent)) if i not in touched}
    assert found["noisy"]
    assert clean <= taken
    assert len(taken - clean) <= 1
    assert found["malformed_bytes"] == len(sent[0]) * (len(sent) - len(taken))
    assert found["bytes"] == len(stream)


def test_what_is_odd_is_shown(tmp_path: Path) -> None:
    file = tmp_path / "odd.bin"
    items = b"\x66\x60\x02\x01\x02" + b"\x10\x20\x02\x00\x07" + b"\x40\x20\x03abc"
    file.write_bytes(message(0xFF, 0x36, items) + message(0xFF, 0xEE, b"x"))
    found = report(file)
    assert found["unknown_items"] == 1
    assert found["misfit_items"] == 1
    first = found["messages"][0]
    assert first["samples"] == [{"bus_id": 255, "counter": 7}]
    assert first["items"][0] == {"id": "0x6660", "name": None, "data": "0102"}
    assert found["messages"][1]["name"] is None
    assert found["message_counts"]["0xEE"] == 1


def test_text_of_bytes_is_read_too(tmp_path: Path) -> None:
    file = tmp_path / "bytes.txt"
    file.write_text("FA FF 30 00 D1\nfaff3100d0\n", encoding="utf-8")
    found = report(file)
    assert [entry["name"] for entry in found["messages"]] == ["GoToConfig", "GoToConfigAck"]
    assert found["kind"] == "hex"


def test_half_a_message_is_malformed(tmp_path: Path) -> None:
    file = tmp_path / "cut.bin"
    file.write_bytes(message(0xFF, 0x30) + b"\xfa\xff\x32\xff\x10" + message(0xFF, 0x31)[:-1])
    found = report(file)
    assert found["frames"] == 1
    assert found["malformed_bytes"] == 9
    assert found["framing"]["incomplete_messages"] >= 1


def test_bad_files_are_named(tmp_path: Path) -> None:
    empty = tmp_path / "empty.bin"
    empty.touch()
    text = tmp_path / "text.bin"
    text.write_text("No bus at all.", encoding="utf-8")
    for file, code, word in [
        (empty, 2, "is empty"),
        (tmp_path / "nowhere.bin", 2, "No such file"),
        (tmp_path, 2, "is a folder"),
        (text, 1, "holds no Xbus message"),
    ]:
        done = decode(file, "--json")
        assert done.returncode == code
        assert str(file) in done.stderr
        assert word in done.stderr
    assert json.loads(decode(text, "--json").stdout)["malformed_bytes"] == 14


@pytest.mark.parametrize(
    "option",
    ["--mode=", "--mode=x", "--mode=0x8000", "--mode=99999", "--settings=4", "--devices=0", "--no"],
)
def test_bad_options_are_named(option: str) -> None:
    done = decode(RECORDINGS / "1" / "output.bin", option)
    assert done.returncode == 2
    assert done.stderr.startswith("xbus-decode: ")


@pytest.mark.parametrize("size", [64, 512])
@pytest.mark.parametrize("status", [b"\x01\x60", b"\x31\x60", b"\x32\x00"])
def test_a_capture_of_an_ftdi_chip_has_its_status_bytes_taken_out(
    tmp_path: Path, size: int, status: bytes
) -> None:
    rng = random.Random(9)
    sent = [suit_data(rng, i, 10) for i in range(200)]
    stream = configuration(10, 4, 0) + b"".join(data for data, _ in sent)
    packets = []
    while stream:
        # A packet is full, or as long as what had come by the end of the latency period.
        count = rng.choice([size - 2, rng.randrange(0, size - 1)])
        packets.append(status + stream[:count])
        stream = stream[count:]
    file = tmp_path / "usb.bin"
    file.write_bytes(b"".join(packets))
    found = report(file)
    assert found["kind"] == "ftdi"
    assert found["frames"] >= 195
    done = decode(file)
    assert "a capture with the status bytes of an FTDI chip, which are left out" in done.stdout


def test_a_plain_stream_loses_nothing(tmp_path: Path) -> None:
    rng = random.Random(10)
    stream = configuration(10, 4, 0) + b"".join(suit_data(rng, i, 10)[0] for i in range(300))
    file = tmp_path / "plain.bin"
    file.write_bytes(stream)
    found = report(file)
    assert found["kind"] == "raw"
    assert found["frames"] == 301
