#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A board with taxels, in Python: its frames are packed by struct, checked by binascii and zlib, written by json.

board.py LINK FORMAT PLACE: LINK is pty (PLACE: a symbolic link to its end), tcp (PLACE: any), udp (PLACE: the port to which it
sends) or file (PLACE: its path). It prints "ready PORT" and obeys lines:
    write TOKEN...   a number or a range 3-9: these frames; cut:N a frame without its last third; flip:N one with a wrong bit;
                     twice:N; noise:HEX; pause:MS
    unplug, plug
    heard            what the other side has sent, as hexadecimal digits
"""
import binascii
import json
import os
import select
import socket
import struct
import sys
import time
import tty
import zlib

TAXELS = 84
CHIPS = 5


def values(n):
    return [(n * 131 + i) & 0xFFFF for i in range(TAXELS)]


def counted(n):
    body = struct.pack("<HBI", 0, n & 0xFF, (n * 2500) & 0xFFFFFFFF) + struct.pack("<84H", *values(n))
    body = struct.pack("<H", len(body) - 2) + body[2:]
    head = b"\xAA\x55" + body
    return head + struct.pack("<H", binascii.crc_hqx(head, 0xFFFF))


def crc32(n):
    body = b"\x7E" + struct.pack(">84h", *[v - 0x8000 for v in values(n)])
    return body + struct.pack(">I", zlib.crc32(body))


def field(n, chip):
    return (25.0 + n / 64, chip + 0.25, -float(n % 1000), 10.0 * chip + n / 8)


def skin(n):
    return b"".join(struct.pack("<4f", *field(n, chip)) for chip in range(CHIPS)) + b"\r\n"


def skin_text(n):
    numbers = [v for chip in range(CHIPS) for v in field(n, chip)[1:] + field(n, chip)[:1]]
    return ("\t".join(repr(v) for v in numbers) + "\r\n").encode()


def csv(n):
    return (",".join([str(n / 400)] + [str(v) for v in values(n)]) + "\r\n").encode()


def text(n):
    return (json.dumps({"t": n / 400, "sensors": [{"data": values(n)}]}) + "\n").encode()


def xela(n):
    data = ",".join("%04X" % v for v in values(n)[:48])
    return (json.dumps({"message": n, "time": 1e9 + n / 100, "1": {"data": data, "taxels": 16}}) + "\n").encode()


FRAMES = {"counted": counted, "crc32": crc32, "skin": skin, "skintext": skin_text, "csv": csv, "json": text, "xela": xela}


class Board:
    def __init__(self, link, form, place):
        self.link, self.frame, self.place = link, FRAMES[form], place
        self.end = self.slave = None
        self.heard = b""
        self.listener = None

    def plug(self):
        if self.link == "pty":
            master, self.slave = os.openpty()
            tty.setraw(master)
            tty.setraw(self.slave)
            os.set_blocking(master, False)
            self.end = master
            temporary = self.place + ".new"
            os.symlink(os.ttyname(self.slave), temporary)
            os.replace(temporary, self.place)
        elif self.link == "tcp":
            if self.listener is None:
                self.listener = socket.create_server(("127.0.0.1", 0))
                self.place = str(self.listener.getsockname()[1])
        elif self.link == "udp":
            self.end = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
            self.end.connect(("127.0.0.1", int(self.place)))
        else:
            self.end = os.open(self.place, os.O_WRONLY | os.O_CREAT | os.O_TRUNC, 0o600)

    def unplug(self):
        if self.link == "pty":
            os.unlink(self.place)
            os.close(self.slave)
            os.close(self.end)
        elif self.end is not None:
            self.end.close()
        self.end = None

    def ready_end(self):
        if self.end is None and self.listener is not None:
            self.end, _ = self.listener.accept()
            self.end.setblocking(False)
        return self.end

    def listen(self):
        if self.link in ("pty", "tcp") and self.ready_end() is not None:
            while select.select([self.end], [], [], 0.05)[0]:
                more = os.read(self.end, 4096) if self.link == "pty" else self.end.recv(4096)
                if not more:
                    break
                self.heard += more

    def put(self, data):
        end = self.ready_end()
        if self.link == "udp":
            try:
                end.send(data)
            except ConnectionRefusedError:
                pass  # nobody listens yet
            return
        while data:
            select.select([], [end], [])
            sent = end.send(data) if self.link == "tcp" else os.write(end, data)
            data = data[sent:]

    def write(self, tokens):
        stream = []
        for token in tokens:
            kind, _, rest = token.rpartition(":")
            if kind == "cut":
                whole = self.frame(int(rest))
                stream.append(whole[: len(whole) * 2 // 3])
            elif kind == "flip":
                whole = bytearray(self.frame(int(rest)))
                whole[len(whole) // 2] ^= 0x04
                stream.append(bytes(whole))
            elif kind == "twice":
                stream += [self.frame(int(rest))] * 2
            elif kind == "noise":
                stream.append(bytes.fromhex(rest))
            elif kind == "pause":
                self.flush(stream)
                time.sleep(int(rest) / 1000)
            else:
                first, _, last = rest.partition("-")
                stream += [self.frame(n) for n in range(int(first), int(last or first) + 1)]
        self.flush(stream)

    def flush(self, stream):
        for data in stream if self.link == "udp" else [b"".join(stream)]:
            self.put(data)
        stream.clear()


def main():
    board = Board(*sys.argv[1:4])
    board.plug()
    print("ready " + board.place, flush=True)
    for line in sys.stdin:
        word, *tokens = line.split()
        if word == "write":
            board.write(tokens)
        elif word == "unplug":
            board.unplug()
        elif word == "plug":
            board.plug()
        elif word == "heard":
            board.listen()
            print("heard " + board.heard.hex(), flush=True)
        print("done", flush=True)


main()
