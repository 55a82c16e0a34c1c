#!/usr/bin/env python3
"""Runs a compiler's command, and mends what it makes: clang 14 lets all threads of a WebAssembly module share the place where a landing pad learns what was caught
(__wasm_lpad_context), while its own library has one for each thread, so that no exception is known by its type. Here the compiler's code asks for the
thread's own, as the library does: by a global that the linker fills in.

    catch_by_thread.py COMPILER WORDS ... -o OBJECT ...

Each access to the address becomes one by the global, as long as before:
    i32.const ADDRESS                              global.get GLOBAL
    i32.const 0, VALUE, i32.store ADDRESS          global.get GLOBAL, VALUE, i32.store 0     (loads alike)
WebAssembly's object files: https://github.com/WebAssembly/tool-conventions/blob/main/Linking.md
"""
import os
import subprocess
import sys

SYMBOL = b"__wasm_lpad_context"
UNDEFINED, EXPLICIT_NAME, TLS = 0x10, 0x40, 0x100
ADDRESS_IN_OFFSET, ADDRESS, GLOBAL = 3, 4, 7                       # kinds of relocations
WITH_ADDEND = {3, 4, 5, 8, 9, 11, 14, 15, 16, 17, 21, 22, 23, 25}
CONST, GET_LOCAL, GET_GLOBAL, MEMORY = 0x41, 0x20, 0x23, range(0x28, 0x3f)


def read_number(data, at):
    """Unsigned LEB128: the number, and where it ends."""
    number = shift = 0
    while True:
        byte = data[at]
        at += 1
        number |= (byte & 0x7f) << shift
        shift += 7
        if byte < 0x80:
            return number, at


def end_of_number(data, at):
    while data[at] >= 0x80:
        at += 1
    return at + 1


def number(value):
    made = bytearray()
    while True:
        value, byte = value >> 7, value & 0x7f
        made.append(byte | (0x80 if value else 0))
        if not value:
            return bytes(made)


def sections_of(data):
    """[kind, name, content without the name] each."""
    if data[:8] != b"\0asm\1\0\0\0":
        return None
    at, sections = 8, []
    while at < len(data):
        kind = data[at]
        size, at = read_number(data, at + 1)
        content, name = data[at:at + size], b""
        if kind == 0:
            length, start = read_number(content, 0)
            name, content = content[start:start + length], content[start + length:]
        sections.append([kind, name, bytearray(content)])
        at += size
    return sections


def file_of(sections):
    made = bytearray(b"\0asm\1\0\0\0")
    for kind, name, content in sections:
        whole = (number(len(name)) + name if kind == 0 else b"") + bytes(content)
        made += bytes([kind]) + number(len(whole)) + whole
    return made


def symbol_made_local(linking):
    """The symbol's index, or None, and the section's content with its flag."""
    version, at = read_number(linking, 0)
    made, found = bytearray(number(version)), None
    while at < len(linking):
        kind = linking[at]
        size, at = read_number(linking, at + 1)
        content = linking[at:at + size]
        at += size
        if kind == 8:
            found, content = in_table(content)
        made += bytes([kind]) + number(len(content)) + content
    return found, made


def in_table(table):
    count, at = read_number(table, 0)
    made, found = bytearray(number(count)), None
    for index in range(count):
        start, kind = at, table[at]
        flags, behind = read_number(table, at + 1)
        at, name = behind, b""
        if kind == 1:   # data
            length, at = read_number(table, at)
            name, at = table[at:at + length], at + length
            for _ in range(0 if flags & UNDEFINED else 3):
                _, at = read_number(table, at)
        elif kind == 3:   # a section
            _, at = read_number(table, at)
        else:
            _, at = read_number(table, at)
            if not flags & UNDEFINED or flags & EXPLICIT_NAME:
                length, at = read_number(table, at)
                at += length
        if bytes(name) == SYMBOL and flags & UNDEFINED:
            found = index
            made += bytes([kind]) + number(flags | TLS) + table[behind:at]
        else:
            made += table[start:at]
    return found, made


def by_global(code, kind, at, addend):
    """Changes the access whose address lies at `at`; where the global's number lies then."""
    if kind == ADDRESS:
        assert code[at - 1] == CONST and addend == 0
        code[at - 1] = GET_GLOBAL
        code[at:at + 5] = b"\x80\x80\x80\x80\0"
        return at
    operation = at - 2
    assert kind == ADDRESS_IN_OFFSET and code[operation] in MEMORY and 0 <= addend < 0x80
    for start in range(operation, operation - 8, -1):   # of the value, which a load has not
        value = bytes(code[start:operation])
        whole = not value or (value[0] in (CONST, GET_LOCAL) and end_of_number(code, start + 1) == operation)
        if whole and code[start - 2:start] == bytes([CONST, 0]) and bool(value) == (code[operation] >= 0x36):
            code[start - 2:at + 5] = bytes([GET_GLOBAL]) + b"\x80\x80\x80\x80\0" + value + bytes([code[operation], code[operation + 1], addend])
            return start - 1
    raise AssertionError("an access to it that is not known")


def mended(data):
    sections = sections_of(data)
    linking = next((one for one in sections or [] if one[1] == b"linking"), None)
    if linking is None or SYMBOL not in linking[2]:
        return data
    symbol, linking[2] = symbol_made_local(linking[2])
    if symbol is None:
        return data
    code, relocations = next(one for one in sections if one[0] == 10), next(one for one in sections if one[1] == b"reloc.CODE")
    section, at = read_number(relocations[2], 0)
    count, at = read_number(relocations[2], at)
    entries = []
    for _ in range(count):
        kind = relocations[2][at]
        offset, at = read_number(relocations[2], at + 1)
        index, at = read_number(relocations[2], at)
        start, at = at, end_of_number(relocations[2], at) if kind in WITH_ADDEND else at
        addend = bytes(relocations[2][start:at])
        if index == symbol and kind in (ADDRESS, ADDRESS_IN_OFFSET):
            offset, kind, addend = by_global(code[2], kind, offset, read_number(addend, 0)[0]), GLOBAL, b""
        entries.append((offset, bytes([kind]) + number(offset) + number(index) + addend))
    entries.sort(key=lambda entry: entry[0])
    relocations[2] = number(section) + number(count) + b"".join(entry for _, entry in entries)
    return file_of(sections)


def main(words):
    ended = subprocess.run(words)
    if ended.returncode != 0 or "-o" not in words:
        return ended.returncode
    made = words[words.index("-o") + 1]
    with open(made, "rb") as file:
        data = file.read()
    changed = mended(data)
    if changed is not data:
        with open(made + ".mended", "wb") as file:
            file.write(changed)
        os.replace(made + ".mended", made)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
