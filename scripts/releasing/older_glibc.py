"""Lets libraries run with an older C library than they were linked with, where a library of the wheel has the functions."""

import struct

NEWER = "GLIBC_2.36"
PT_LOAD, PT_DYNAMIC = 1, 2
DT_NULL, DT_STRTAB, DT_VERNEED, DT_VERNEEDNUM = 0, 5, 0x6FFFFFFE, 0x6FFFFFFF


def segments(data):
    """Kind, offset, address and size in the file of each segment."""
    table, = struct.unpack_from("<Q", data, 32)
    size, count = struct.unpack_from("<HH", data, 54)
    for header in range(table, table + size * count, size):
        kind, _, offset, address, _, length = struct.unpack_from("<IIQQQQ", data, header)
        yield kind, offset, address, length


def dynamic_entries(data):
    for kind, offset, _, length in segments(data):
        if kind == PT_DYNAMIC:
            return dict(struct.unpack_from("<QQ", data, at) for at in range(offset, offset + length, 16))
    return {}


def offset_of(data, wanted):
    for kind, offset, address, length in segments(data):
        if kind == PT_LOAD and address <= wanted < address + length:
            return offset + wanted - address
    raise SystemExit(f"release: no segment holds the address {wanted:#x}")


def text_at(data, at):
    return bytes(data[at:data.index(0, at)]).decode()


def needed_versions(data):
    """For each library whose versions a file needs: a dictionary of their entries' places by their names."""
    entries = dynamic_entries(data)
    if DT_VERNEED not in entries:
        return
    names, at = offset_of(data, entries[DT_STRTAB]), offset_of(data, entries[DT_VERNEED])
    for _ in range(entries[DT_VERNEEDNUM]):
        _, count, _, first, following = struct.unpack_from("<HHIII", data, at)
        found, place = {}, at + first
        for _ in range(count):
            name, step = struct.unpack_from("<II", data, place + 8)
            found[text_at(data, names + name)] = place
            place += step
        yield found
        at += following


def with_older_version(data):
    """The bytes of a library that asks for an old version in place of the newer one: no C library has its functions under that name, and
    the linker takes them from a library without versions."""
    data = bytearray(data)
    for found in list(needed_versions(data)):
        if NEWER in found:
            older = found[min((name for name in found if name.startswith("GLIBC_")), key=lambda name: [int(n) for n in name[6:].split(".")])]
            data[found[NEWER]:found[NEWER] + 4] = data[older:older + 4]  # The hash...
            data[found[NEWER] + 8:found[NEWER] + 12] = data[older + 8:older + 12]  # ...and the name.
    return bytes(data)
