# SPDX-License-Identifier: MIT
"""crater.py HEADER LIBRARY LEVEL.obj: crater.cpp in Python, through ctypes and the shared library of the C API. Structs have
the fields that the installed firma_c.h gives them."""
import ctypes as c
import re
import sys

TYPES = {'double': c.c_double, 'uint64_t': c.c_uint64, 'uint32_t': c.c_uint32, 'int32_t': c.c_int32, 'uint8_t': c.c_uint8}

with open(sys.argv[1], encoding='utf-8') as file:
    header = re.sub(r'/\*.*?\*/', '', file.read(), flags=re.DOTALL)


def struct(name):
    """The struct as a class of ctypes: numbers, other structs and arrays of these."""
    fields = []
    for kind, names in re.findall(r'(\w+) ([^;]+);', re.search(rf'struct {name} {{(.*?)}}', header, re.DOTALL).group(1)):
        for field, length in re.findall(r'(\w+)(?:\[(\w+)\])?(?:,|$)', names):
            if length and not length.isdigit():
                length = re.search(rf'#define {length} (\d+)', header).group(1)
            of = TYPES.get(kind) or struct(kind)
            fields.append((field, of * int(length) if length else of))
    return type(name, (c.Structure,), {'_fields_': fields})


Handle, Input, Hit, Pose = (struct(name) for name in ('firma_world', 'firma_cast_input', 'firma_hit', 'firma_pose'))
Report = struct('firma_carve_report')

firma = c.CDLL(sys.argv[2])
firma.firma_error_message.restype = c.c_char_p


def call(name, *arguments):
    if getattr(firma, name)(*arguments) != 0:
        sys.exit(f'{name}: {firma.firma_error_message().decode()}')


world, after, cutter = Handle(), Handle(), Handle()  # each a number
call('firma_world_load', sys.argv[3].encode(), None, c.byref(world))
hit = Hit()
call('firma_cast', world, c.byref(Input((35, 29, 2), 0.5, (0, 0, 10))), None, c.byref(hit), None)
material = c.c_char_p()
call('firma_world_material', world, c.c_uint32(hit.material), c.byref(material))
call('firma_cutter_crater', c.c_uint32(0), c.c_uint64(1), c.byref(cutter))
report = Report(size=c.sizeof(Report))
call('firma_carve', world, cutter, c.byref(Pose(hit.point, (0, 0, 0, 1), 1.5)), None, c.byref(after), c.byref(report))
hashed = c.c_uint64()
call('firma_world_hash', after, c.byref(hashed))
print(f'met {material.value.decode()} after {hit.fraction:.17g}, hash {hashed.value:016x}')
