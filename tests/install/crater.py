# SPDX-License-Identifier: MIT
"""crater.py LIBRARY LEVEL.obj: crater.cpp in Python, through ctypes and the shared library of the C API."""
import ctypes as c
import sys


class Handle(c.Structure):
    _fields_ = [('id', c.c_uint64)]


class Input(c.Structure):
    _fields_ = [('centre', c.c_double * 3), ('radius', c.c_double), ('path', c.c_double * 3)]


class Hit(c.Structure):
    """The first fields of firma_hit, and room for the others."""
    _fields_ = [('fraction', c.c_double), ('safe_fraction', c.c_double), ('centre', c.c_double * 3), ('point', c.c_double * 3), ('normal', c.c_double * 3),
                ('face_normal', c.c_double * 3), ('version', c.c_uint64), ('status', c.c_uint32), ('feature', c.c_uint32), ('feature_index', c.c_uint32),
                ('face', c.c_uint32), ('other_face', c.c_uint32), ('source', c.c_uint32), ('source_edit', c.c_uint32), ('material', c.c_uint32),
                ('others', c.c_uint8 * 256)]


class Pose(c.Structure):
    _fields_ = [('position', c.c_double * 3), ('rotation', c.c_double * 4), ('scale', c.c_double)]


firma = c.CDLL(sys.argv[1])
firma.firma_error_message.restype = c.c_char_p


def call(name, *arguments):
    if getattr(firma, name)(*arguments) != 0:
        sys.exit(f'{name}: {firma.firma_error_message().decode()}')


world, after, cutter = Handle(), Handle(), Handle()
call('firma_world_load', sys.argv[2].encode(), None, c.byref(world))
hit = Hit()
call('firma_cast', world, c.byref(Input((35, 29, 2), 0.5, (0, 0, 10))), None, c.byref(hit), None)
material = c.c_char_p()
call('firma_world_material', world, c.c_uint32(hit.material), c.byref(material))
call('firma_cutter_crater', c.c_uint32(0), c.c_uint64(1), c.byref(cutter))
report = (c.c_uint64 * 64)()
call('firma_carve', world, cutter, c.byref(Pose(hit.point, (0, 0, 0, 1), 1.5)), None, c.byref(after), report)
hashed = c.c_uint64()
call('firma_world_hash', after, c.byref(hashed))
print(f'met {material.value.decode()} after {hit.fraction:.17g}, hash {hashed.value:016x}')
