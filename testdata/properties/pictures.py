# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures as the formats' specifications say: PNG, TIFF without compression, OpenEXR (ZIP) and PNM
decoded here, all with the same pixels; no clock in them; SVG by an XML parser; there and back;
limits of time and memory for images and models that mean harm."""
import os
import pty
import resource
import struct
import subprocess
import sys
import zlib
from xml.etree import ElementTree

DATA = os.environ['DATA']
bad = False


def complain(text):
    global bad
    bad = True
    print(text)


def run(*words, data=None):
    return subprocess.run(words, input=data, stdout=subprocess.PIPE, check=True).stdout


def read_pnm(b):
    kind, size, full, data = b.split(b'\n', 3)
    w, h = map(int, size.split())
    n = 2 if int(full) > 255 else 1
    channels = 3 if kind == b'P6' else 1
    return w, h, channels, list(struct.unpack('>%d%s' % (w * h * channels, 'BH'[n - 1]), data))


def unfilter(rows, h, stride, bpp):
    out, before = bytearray(), bytes(stride)
    for y in range(h):
        kind, row = rows[y * (stride + 1)], bytearray(rows[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for i in range(stride):
            a = row[i - bpp] if i >= bpp else 0
            b, c = before[i], before[i - bpp] if i >= bpp else 0
            p = a + b - c
            paeth = min((abs(p - a), 0, a), (abs(p - b), 1, b), (abs(p - c), 2, c))[2]
            row[i] = row[i] + (0, a, b, (a + b) // 2, paeth)[kind] & 255
        out += row
        before = row
    return bytes(out)


def read_png(b):
    assert b[:8] == b'\x89PNG\r\n\x1a\n'
    at, pixels, names = 8, b'', []
    while at < len(b):
        n, name = struct.unpack('>I4s', b[at:at + 8])
        chunk = b[at + 8:at + 8 + n]
        assert struct.unpack('>I', b[at + 8 + n:at + 12 + n])[0] == zlib.crc32(name + chunk)
        names.append(name)
        if name == b'IHDR':
            w, h, depth, colour, _, _, interlace = struct.unpack('>IIBBBBB', chunk)
        elif name == b'IDAT':
            pixels += chunk
        at += 12 + n
    assert names[-1] == b'IEND' and interlace == 0 and b'tIME' not in names and b'tEXt' not in names
    channels = {0: 1, 2: 3, 4: 2, 6: 4}[colour]
    bpp = channels * depth // 8
    raw = unfilter(zlib.decompress(pixels), h, w * bpp, bpp)
    return w, h, channels, list(struct.unpack('>%d%s' % (w * h * channels, 'BH'[depth // 8 - 1]), raw))


def read_tiff(b):
    assert b[:4] == b'II*\0'
    tag = {}
    at = struct.unpack('<I', b[4:8])[0]
    for _ in range(struct.unpack('<H', b[at:at + 2])[0]):
        at += 12 if tag else 2
        key, kind, n = struct.unpack('<HHI', b[at:at + 8])
        size = {1: 1, 2: 1, 3: 2, 4: 4, 5: 8, 12: 8}[kind] * n
        place = at + 8 if size <= 4 else struct.unpack('<I', b[at + 8:at + 12])[0]
        value = b[place:place + size]
        tag[key] = value if kind in (2, 5, 12) else struct.unpack('<%d%s' % (n, ' B HI'[kind]), value)
    assert tag[259] == (1,) and tag[306] == b'1970:01:01 00:00:00\0'
    w, h, channels, bits = tag[256][0], tag[257][0], tag[277][0], tag[258][0]
    raw = b''.join(b[o:o + n] for o, n in zip(tag[273], tag[279]))
    form = {(8, 1): 'B', (16, 1): 'H', (16, 3): 'e', (32, 3): 'f'}[bits, tag.get(339, (1,))[0]]
    assert tag.get(284, (1,)) == (1,)
    return w, h, channels, list(struct.unpack('<%d%s' % (w * h * channels, form), raw))


def read_exr(b):
    """One part of scan lines, 16 in a block compressed by ZIP, all channels of one type."""
    at, header = 8, {}
    while b[at]:
        name, kind, rest = b[at:at + 600].split(b'\0', 2)
        at += len(name) + len(kind) + 2
        n = struct.unpack('<I', b[at:at + 4])[0]
        header[name] = b[at + 4:at + 4 + n]
        at += 4 + n
    x0, y0, x1, y1 = struct.unpack('<4i', header[b'dataWindow'])
    names, kinds, rest = [], set(), header[b'channels']
    while rest[0]:
        name, rest = rest.split(b'\0', 1)
        names.append(name.decode())
        kinds.add(struct.unpack('<I', rest[:4])[0])
        rest = rest[16:]
    assert header[b'compression'] == b'\3' and header[b'capDate'] == b'1970:01:01 00:00:00'
    form, = {'e' if k == 1 else 'f' for k in kinds}
    w, h, size = x1 - x0 + 1, y1 - y0 + 1, 2 if form == 'e' else 4
    order = sorted(range(len(names)), key=lambda i: 'RGBAY'.find(names[i]))
    at += 1 + 8 * ((h + 15) // 16)
    value = [0.0] * (w * h * len(names))
    for first in range(0, h, 16):
        lines = min(16, h - first)
        y, n = struct.unpack('<ii', b[at:at + 8])
        data, whole = b[at + 8:at + 8 + n], lines * w * len(names) * size
        at += 8 + n
        if n < whole:
            d = bytearray(zlib.decompress(data))
            for i in range(1, whole):
                d[i] = d[i - 1] + d[i] - 128 & 255
            half = (whole + 1) // 2
            data = bytes(d[i // 2 + (i % 2) * half] for i in range(whole))
        numbers = struct.unpack('<%d%s' % (whole // size, form), data)
        for line in range(lines):
            for c in range(len(names)):
                for x in range(w):
                    place = ((y - y0 + line) * w + x) * len(names) + order.index(c)
                    value[place] = numbers[(line * len(names) + c) * w + x]
    return w, h, len(names), value


def same(what, a, b, scale=1, tolerance=0.0):
    if a[:3] != b[:3] or any(abs(x * scale - y) > tolerance for x, y in zip(a[3], b[3])):
        complain(what + ': not the same pixels')


def formats():
    """Of one picture."""
    for model in (['--squares', '7'], ['--background', 'none', '--colors', 'red,0000ff40']):
        words = ['render-checker', '--size', '53x37', *model, DATA + '/good/obj-texture/sheared.obj']
        png, tiff, exr = (run(*words, '--to', to) for to in ('png', 'tiff', 'exr'))
        same('TIFF', read_tiff(tiff), read_png(png))
        flat = read_exr(exr)
        if flat[2] == 4: # colours are multiplied by alpha there
            for i in range(0, len(flat[3]), 4):
                for k in range(3):
                    flat[3][i + k] /= flat[3][i + 3] or 1
        same('OpenEXR', flat, read_png(png), 255, 0.8)
        if flat[2] == 3:
            same('PNM', read_pnm(run(*words, '--to', 'pnm')), read_png(png))
        if png != run(*words, '--to', 'png'):
            complain('another PNG the second time')
        with open('picture.png', 'wb') as file:
            file.write(png)
        run('pngcheck', '-q', 'picture.png')


def tiff_header(entries):
    """A directory of numbers; an offset of strips (tag 273) that is 0 becomes that of its end."""
    end = 8 + 2 + 12 * len(entries) + 4
    return struct.pack('<2sHIH', b'II', 42, 8, len(entries)) + b''.join(
        struct.pack('<HHII', key, 4, 1, end if (key, value) == (273, 0) else value)
        for key, value in entries) + bytes(4)


def samples():
    """Of 16 bits, halves and floats, there and back."""
    deep = b'P6\n5 4\n65535\n' + bytes((i * 37 + i * i) & 255 for i in range(5 * 4 * 6))
    grid = run('mkgrid', '--rect', '0,0,5,4', '--cells', '2x2')
    with open('deep.ppm', 'wb') as file:
        file.write(deep)
    for to, reader in (('png', read_png), ('tiff', read_tiff), ('pnm', read_pnm)):
        same('16 bits as ' + to, reader(run('warp-image', '--to', to, 'deep.ppm', data=grid)),
             read_pnm(deep))
    floats = [i * i / 7 - 3 for i in range(5 * 4)]
    for form, bits in (('e', 16), ('f', 32)):
        pixels = struct.pack('<20' + form, *floats)
        tiff = tiff_header(((256, 5), (257, 4), (258, bits), (259, 1), (262, 1), (273, 0), (277, 1),
                            (278, 4), (279, len(pixels)), (339, 3)))
        with open('floats.tif', 'wb') as file:
            file.write(tiff + pixels)
        want = (5, 4, 1, list(struct.unpack('<20' + form, pixels)))
        for to, reader in (('tiff', read_tiff), ('exr', read_exr)):
            same(form + ' as ' + to, reader(run('warp-image', '--to', to, 'floats.tif', data=grid)), want)


def terminal():
    """Pixels do not go there. (A bare chroot has none; CI has.)"""
    try:
        master, slave = pty.openpty()
    except OSError:
        if os.environ.get('SUPPLE_STRICT'):
            raise
        return
    words = ['render-checker', '--size', '4x4', DATA + '/good/obj-texture/sheared.obj']
    done = subprocess.run(words, stdout=slave, stderr=subprocess.PIPE, check=False)
    if done.returncode != 2 or b'terminal' not in done.stderr:
        complain('a picture goes to a terminal')
    os.close(master)
    os.close(slave)


def bombs():
    """PNGs that promise more than they hold, and texts that unfold to gigabytes."""
    def chunk(name, data):
        return struct.pack('>I', len(data)) + name + data + struct.pack('>I', zlib.crc32(name + data))

    def png(w, h, more, pixels):
        header = struct.pack('>IIBBBBB', w, h, 16, 6, 0, 0, 0)
        return (b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', header) + more +
                chunk(b'IDAT', zlib.compress(pixels)) + chunk(b'IEND', b''))

    text = chunk(b'zTXt', b'a\0\0' + zlib.compress(bytes(7000000)))
    profile = chunk(b'iCCP', b'a\0\0' + zlib.compress(bytes(7000000)))
    yield 'promise', png(9999, 9999, b'', bytes(100))
    yield 'texts', png(2, 2, text * 300 + profile, bytes(100))
    yield 'tile', tiff_header(((256, 4), (257, 4), (258, 8), (259, 1), (262, 1), (277, 1),
                               (322, 1 << 20), (323, 1 << 16), (324, 8), (325, 16)))


def files_below(folder):
    return sorted(os.path.join(at, name) for at, _, names in os.walk(os.path.join(DATA, folder))
                  for name in names)


def bounded(*words):
    """An error, or a picture, within 1 s and 1 GB."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(words, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, check=False)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    spent = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    text = ' '.join(words)
    if done.returncode not in (0, 1, 3) or (done.returncode == 0) != (done.stderr == b''):
        complain('%s: status %d, %r' % (text, done.returncode, done.stderr[:200]))
    if done.returncode and (done.stdout or done.stderr.count(b'\n') != 1):
        complain('%s: %d bytes, %r' % (text, len(done.stdout), done.stderr[:200]))
    if spent > 1:
        complain('%s takes %.1f s' % (text, spent))
    if after.ru_maxrss > 1 << 20: # the largest of all children until now
        sys.exit('%s takes %d KB' % (text, after.ru_maxrss))


def hostile():
    images = files_below('hostile/images')
    for name, data in bombs():
        with open(name, 'wb') as file:
            file.write(data)
        images.append(name)
    with open('a.grid', 'wb') as file:
        file.write(run('mkgrid', '--rect', '0,0,9,9', '--cells', '1x1', '--degree', '1'))
    for name in images:
        bounded('warp-image', '--to', 'pnm', name, 'a.grid')
        bounded('draw-grid', '--width', '90', '--image', name, 'a.grid')
        bounded('render-checker', '--size', '9x9', '--texture', name, 'a.grid')
    for name in files_below('hostile/obj') + images[:4]:
        bounded('render-model', name)
        bounded('render-checker', name)
        bounded('draw-grid', '--width', '90', '--model', name, 'a.grid')
        bounded('draw-grid', '--width', '90', '--no-grid', '--lines', name)


def there_and_back():
    """A smooth image through a deformation and its inverse."""
    n = 96
    smooth = [round(30000 + 20000 * (x * (n - x) - y * (n - y) / 2) / n ** 2 + 60 * x)
              for y in range(n) for x in range(n)]
    with open('smooth.pgm', 'wb') as file:
        file.write(b'P5\n%d %d\n65535\n' % (n, n) + struct.pack('>%dH' % (n * n), *smooth))
    edit = 'rotate v@48,48 about 48 48 by 20 reach 10'
    grid = run('decles-edit', '-e', edit, data=run('mkgrid', '--rect', '0,0,96,96', '--cells', '8x8'))
    words = ['warp-image', '--filter', 'cubic', '--to', 'pnm']
    there = run(*words, 'smooth.pgm', data=grid)
    with open('there.pgm', 'wb') as file:
        file.write(there)
    back = read_pnm(run(*words, '--inverse', 'there.pgm', data=grid))[3]
    inside = [i for i in range(n * n) if 8 < i % n < n - 8 and 8 < i // n < n - 8]
    if max(abs(back[i] - smooth[i]) for i in inside) > 4:
        complain('an image that goes there does not come back')
    if max(abs(read_pnm(there)[3][i] - smooth[i]) for i in inside) < 300:
        complain('an image does not go there')


def vectors():
    """SVGs of all layers are well-formed; the same again."""
    layers = ['triangles', 'net', 'points', 'types', 'quads', 'labels', 'jacobian', 'outline', 'sets']
    grid = run('mkgrid', '--rect', '0,0,4,2', '--cells', '2x1')
    with open('e.edits', 'w') as file:
        file.write('edits 1\nmove v@2,1 by 0.3 0.2 reach 6\n')
    for chosen in layers + [','.join(layers)]:
        words = ['draw-grid', '--to', 'svg', '--side', 'both', '--layers', chosen, '--edit', 'e.edits:2']
        svg = run(*words, data=grid)
        if ElementTree.fromstring(svg).tag != '{http://www.w3.org/2000/svg}svg':
            complain(chosen + ': no SVG')
        if svg != run(*words, data=grid):
            complain(chosen + ': another SVG the second time')


formats()
samples()
terminal()
there_and_back()
vectors()
hostile()
sys.exit(1 if bad else 0)
