"""A textured box that tumbles about its middle axis, drawn with moderngl as one writes it in an afternoon.

    tumbling_box.py png OUTPUT.mp4    frames as PNGs, saved by Pillow; ffmpeg makes the clip of them
    tumbling_box.py raw OUTPUT.mp4    frames piped to ffmpeg; no PNGs

1280x720, 4x multisampled, no display. Prints frames, seconds and processor seconds, ffmpeg's included.
"""
import argparse
import math
import os
import struct
import subprocess
import tempfile
import time

import moderngl
from PIL import Image

WIDTH, HEIGHT, RATE = 1280, 720, 60
BOOK = (0.1878, 0.29085, 0.05)  # x, y, z [m]
CAMERA_DISTANCE = 0.72  # [m]
ASSETS = os.path.join(os.path.dirname(__file__), "../../assets")
ENCODE = ["-c:v", "libx264", "-preset", "veryfast", "-crf", "18", "-pix_fmt", "yuv420p"]

VERTEX = """
#version 330
uniform mat4 clip_from_view;
uniform mat3 turn;
uniform float distance;
in vec3 position;
in vec3 normal;
in vec2 uv;
out vec3 turned_normal;
out vec2 cover_uv;
void main() {
  turned_normal = turn * normal;
  cover_uv = uv;
  gl_Position = clip_from_view * vec4(turn * position - vec3(0, 0, distance), 1);
}
"""

FRAGMENT = """
#version 330
uniform sampler2D cover;
in vec3 turned_normal;
in vec2 cover_uv;
out vec3 colour;
void main() {
  float light = 0.35 + 0.65 * max(dot(normalize(turned_normal), normalize(vec3(0.3, 0.5, 1))), 0);
  colour = light * texture(cover, cover_uv).rgb;
}
"""


def box_vertices():
    """Position, normal and texture coordinates of 36 vertices."""
    half = [side / 2 for side in BOOK]
    values = []
    for axis in range(3):
        across, up = (axis + 1) % 3, (axis + 2) % 3
        for sign in (-1, 1):
            for u, v in ((0, 0), (1, 0), (1, 1), (0, 0), (1, 1), (0, 1)):
                position, normal = [0.0] * 3, [0.0] * 3
                position[axis] = sign * half[axis]
                position[across] = (2 * u - 1) * half[across]
                position[up] = (2 * v - 1) * half[up]
                normal[axis] = sign
                values += position + normal + [u, v]
    return struct.pack(f"{len(values)}f", *values)


def perspective():
    """30 degrees from bottom to top; columns one after the other."""
    near, far = 0.1, 10
    scale = 1 / math.tan(math.radians(15))
    return struct.pack("16f", scale * HEIGHT / WIDTH, 0, 0, 0, 0, scale, 0, 0,
                       0, 0, (far + near) / (near - far), -1, 0, 0, 2 * far * near / (near - far), 0)


def attitudes(count):
    """Quaternions of a free rigid box, frame by frame: Euler's equations in small steps."""
    a, b, c = (side * side for side in BOOK)
    inertia = (b + c, a + c, a + b)
    w, q = [4.0, 0.0, 0.0012], [1.0, 0.0, 0.0, 0.0]
    steps = 20
    h = 1 / (RATE * steps)
    for _ in range(count):
        yield q
        for _ in range(steps):
            w = [w[i] + h * (inertia[(i + 1) % 3] - inertia[(i + 2) % 3]) / inertia[i]
                 * w[(i + 1) % 3] * w[(i + 2) % 3] for i in range(3)]
            s, x, y, z = q
            q = [s - h / 2 * (x * w[0] + y * w[1] + z * w[2]), x + h / 2 * (s * w[0] + y * w[2] - z * w[1]),
                 y + h / 2 * (s * w[1] + z * w[0] - x * w[2]), z + h / 2 * (s * w[2] + x * w[1] - y * w[0])]
            size = math.sqrt(sum(part * part for part in q))
            q = [part / size for part in q]


def matrix(q):
    """The rotation matrix; columns one after the other."""
    s, x, y, z = q
    return struct.pack("9f", 1 - 2 * (y * y + z * z), 2 * (x * y + s * z), 2 * (x * z - s * y),
                       2 * (x * y - s * z), 1 - 2 * (x * x + z * z), 2 * (y * z + s * x),
                       2 * (x * z + s * y), 2 * (y * z - s * x), 1 - 2 * (x * x + y * y))


class Box:
    """Draws the box into memory."""

    def __init__(self):
        context = self.context = moderngl.create_standalone_context(backend="egl")
        self.program = context.program(vertex_shader=VERTEX, fragment_shader=FRAGMENT)
        self.program["clip_from_view"].write(perspective())
        self.program["distance"] = CAMERA_DISTANCE
        self.vertices = context.vertex_array(
            self.program, [(context.buffer(box_vertices()), "3f 3f 2f", "position", "normal", "uv")])
        cover = Image.open(os.path.join(ASSETS, "front.png")).convert("RGB").transpose(Image.FLIP_TOP_BOTTOM)
        self.cover = context.texture(cover.size, 3, cover.tobytes())
        self.cover.build_mipmaps()
        self.cover.use()
        self.samples = context.framebuffer([context.renderbuffer((WIDTH, HEIGHT), samples=4)],
                                           context.depth_renderbuffer((WIDTH, HEIGHT), samples=4))
        self.picture = context.framebuffer([context.renderbuffer((WIDTH, HEIGHT))])
        context.enable(moderngl.DEPTH_TEST)

    def draw(self, q):
        """RGB bytes, bottom row first."""
        self.samples.use()
        self.samples.clear(0.07, 0.07, 0.08)
        self.program["turn"].write(matrix(q))
        self.vertices.render()
        self.context.copy_framebuffer(self.picture, self.samples)
        return self.picture.read(components=3, alignment=1)


def render_pngs(count, output):
    """Every frame a PNG, then a clip of them."""
    box = Box()
    with tempfile.TemporaryDirectory() as folder:
        for index, q in enumerate(attitudes(count)):
            picture = Image.frombytes("RGB", (WIDTH, HEIGHT), box.draw(q)).transpose(Image.FLIP_TOP_BOTTOM)
            picture.save(os.path.join(folder, f"frame_{index:05}.png"))
        subprocess.run(["ffmpeg", "-loglevel", "error", "-y", "-framerate", str(RATE),
                        "-i", os.path.join(folder, "frame_%05d.png"), *ENCODE, output], check=True)


def render_raw(count, output):
    """A clip alone."""
    box = Box()
    command = ["ffmpeg", "-loglevel", "error", "-y", "-f", "rawvideo", "-pix_fmt", "rgb24",
               "-s", f"{WIDTH}x{HEIGHT}", "-framerate", str(RATE), "-i", "-", "-vf", "vflip", *ENCODE, output]
    with subprocess.Popen(command, stdin=subprocess.PIPE) as ffmpeg:
        for q in attitudes(count):
            ffmpeg.stdin.write(box.draw(q))
    if ffmpeg.returncode != 0:
        raise SystemExit(f"tumbling_box: ffmpeg failed with status {ffmpeg.returncode}")


def main():
    parser = argparse.ArgumentParser(description="draw a tumbling box with moderngl and make a clip of it")
    parser.add_argument("way", choices=["png", "raw"], help="PNGs first, or frames piped to ffmpeg")
    parser.add_argument("output", help="MP4 to write")
    parser.add_argument("--frames", type=int, default=300)
    arguments = parser.parse_args()
    start = time.monotonic()
    {"png": render_pngs, "raw": render_raw}[arguments.way](arguments.frames, arguments.output)
    seconds, used = time.monotonic() - start, os.times()
    processor = used.user + used.system + used.children_user + used.children_system
    print(f"{arguments.frames} frames, {seconds:.2f} s, {processor:.2f} s of processor time")


main()
