# SPDX-License-Identifier: GPL-3.0-or-later
"""A Modbus server by pymodbus that a test runs and makes fail on demand.

    modbus_server.py tcp [PORT]     on the loopback address; port 0: any
    modbus_server.py rtu DEVICE     on a serial line, server address 1

It says "ready PORT" or "ready DEVICE" first, and "write ADDRESS WORD..." for each write that it carries out. On its
standard input it takes, and answers with "done":
    set ADDRESS WORD...             holding and input registers
    float ADDRESS VALUE [swapped]   a number of two registers
    int ADDRESS VALUE [swapped]
    fault none
    fault exception                 requests are refused with exception 2 and not carried out
    fault silent                    carried out, no answer
    fault drop                      not carried out, no answer: the request was lost on its way
    fault late SECONDS              carried out, then answered late
    fault garbage                   carried out, answered with bytes that are no answer
    hangup                          closes the connections
    watchdog ADDRESS N COUNT S      N registers become 0 when the register COUNT stands still for S seconds
    sync                            nothing: all lines before its "done" are older
Registers 0 to 999 exist.
"""
import asyncio
import struct
import sys
import time

from pymodbus.datastore import ModbusSequentialDataBlock, ModbusServerContext, ModbusSlaveContext
from pymodbus.server.async_io import ModbusSerialServer, ModbusTcpServer


def say(*words):
    print(*words, flush=True)


class Registers(ModbusSlaveContext):
    """Two tables of registers that tell what is written and refuse on demand."""

    def __init__(self):
        super().__init__(
            hr=ModbusSequentialDataBlock(0, [0] * 1000), ir=ModbusSequentialDataBlock(0, [0] * 1000), zero_mode=True
        )
        self.refuses = False
        self.drops = False

    def validate(self, fc_as_hex, address, count=1):
        return not self.refuses and super().validate(fc_as_hex, address, count)

    def setValues(self, fc_as_hex, address, values):
        if self.drops:
            return
        super().setValues(fc_as_hex, address, values)
        say("write", address, *values)

    def put(self, address, words):
        self.store["h"].setValues(address, words)
        self.store["i"].setValues(address, words)


class Peer:
    def __init__(self):
        self.registers = Registers()
        self.context = ModbusServerContext(slaves={1: self.registers}, single=False)
        self.fault = "none"
        self.delay_s = 0.0
        self.server = None

    def answer(self, response):
        if self.fault in ("silent", "drop"):
            response.should_respond = False
        elif self.fault == "late":
            time.sleep(self.delay_s)
        elif self.fault == "garbage":
            return b"\x55" * 11, True
        return response, False

    def put_number(self, kind, words):
        address = int(words[0])
        packed = struct.pack(">f", float(words[1])) if kind == "float" else struct.pack(">i", int(words[1]))
        registers = list(struct.unpack(">HH", packed))
        self.registers.put(address, registers[::-1] if words[2:] == ["swapped"] else registers)

    def command(self, line):
        verb, *words = line.split()
        if verb == "set":
            self.registers.put(int(words[0]), [int(word) for word in words[1:]])
        elif verb in ("float", "int"):
            self.put_number(verb, words)
        elif verb == "fault":
            self.fault = words[0]
            self.delay_s = float(words[1]) if len(words) > 1 else 0.0
            self.registers.refuses = self.fault == "exception"
            self.registers.drops = self.fault == "drop"
        elif verb == "hangup":
            for connection in list(self.server.active_connections.values()):
                connection.transport.abort()
        elif verb == "watchdog":
            address, number, count = (int(word) for word in words[:3])
            self.watch = asyncio.create_task(self.watchdog(address, number, count, float(words[3])))
        elif verb != "sync":
            raise ValueError(line)
        say("done")

    async def watchdog(self, address, number, count, patience_s):
        last, since = None, time.monotonic()
        while True:
            await asyncio.sleep(0.005)
            now = self.registers.store["h"].getValues(count, 1)
            if now != last:
                last, since = now, time.monotonic()
            elif time.monotonic() - since > patience_s:
                self.registers.store["h"].setValues(address, [0] * number)

    async def run(self, kind, where):
        if kind == "tcp":
            self.server = ModbusTcpServer(
                self.context,
                address=("127.0.0.1", int(where)),
                allow_reuse_address=True,
                response_manipulator=self.answer,
            )
            asyncio.create_task(self.server.serve_forever())
            await self.server.serving
            where = self.server.server.sockets[0].getsockname()[1]
        else:
            self.server = ModbusSerialServer(
                self.context, port=where, baudrate=115200, timeout=1, response_manipulator=self.answer
            )
            await self.server.start()
        say("ready", where)
        reader = asyncio.StreamReader()
        loop = asyncio.get_running_loop()
        await loop.connect_read_pipe(lambda: asyncio.StreamReaderProtocol(reader), sys.stdin)
        while line := await reader.readline():
            self.command(line.decode())


if __name__ == "__main__":

    async def main():
        # The servers look for the running loop when they are made.
        await Peer().run(sys.argv[1], sys.argv[2] if len(sys.argv) > 2 else "0")

    asyncio.run(main())
