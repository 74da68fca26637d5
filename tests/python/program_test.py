"""What the program does for the installed package."""

import os
import pathlib
import shutil
import signal
import subprocess
import sys
import time
import unittest
import unittest.mock

import numpy as np

import rotatebook
from rotatebook import ProgramError, Scene, SceneError

SOURCE = pathlib.Path(os.environ["ROTATEBOOK_SOURCE"])
SMALL = Scene('[initial]\nangular_velocity = [5.0, 0.05, 0.0]\n[clip]\nduration = 0.5\nsize = [160, 90]\n', name="small")


class Clips(unittest.TestCase):
    def test_show_themselves_and_that_they_are_proved(self):
        seen = []
        clip = rotatebook.render(SMALL, "clips", overwrite=True, progress=lambda done, whole: seen.append((done, whole)))
        self.assertEqual(seen, [(30, 30)])
        self.assertTrue(clip._repr_html_().startswith('<figure><video controls loop src="data:video/mp4;base64,'))
        self.assertNotIn("proved", clip._repr_html_())
        proof = clip.verify()
        self.assertTrue(proof.proved)
        self.assertIn("<figcaption>proved</figcaption>", clip._repr_html_())
        motion = next(check for check in proof.report["checks"] if check["check"] == "motion")
        self.assertEqual(motion["measured"], SMALL.simulate().checksum)
        with open(clip.file, "ab") as file:
            file.write(b"\0")
        self.assertNotIn("proved", clip._repr_html_(), "these are other bytes")

    def test_have_the_textures_beside_a_text_and_are_made_for_editors(self):
        shutil.copy(SOURCE / "assets/front.png", "cover.png")
        scene = Scene(SMALL.text + '[book]\nfront = "cover.png"\n', name="covered")
        clip = rotatebook.render(scene, "editors", format="prores", overwrite=True)
        self.assertEqual(clip.file.name, "covered.mov")
        self.assertIn("data:video/quicktime;base64,", clip._repr_html_())

    def test_of_every_format_show_themselves(self):
        kinds = {"mp4": "video/mp4", "webm": "video/webm", "gif": "image/gif", "apng": "image/apng"}
        for name, kind in kinds.items():
            clip = rotatebook.render(SMALL, "formats", format=name, overwrite=True)
            self.assertIn(f'src="data:{kind};base64,', clip._repr_html_())
        other = pathlib.Path("a<b.mkv")
        other.write_bytes(b"no format of the program")
        self.assertEqual(rotatebook.Clip(other)._repr_html_(), "<code>a&lt;b.mkv</code>")

    def test_of_scenes_with_any_ending_say_where_the_mistake_is(self):
        for name in ("bad.txt", "bad (1).scene"):
            pathlib.Path(name).write_text("[body]\nmass = 3\nmaas = 3\nsize = 1\n")
            with self.assertRaises(SceneError) as refused:
                rotatebook.render(name)
            self.assertEqual([mistake[:2] for mistake in refused.exception.mistakes], [(3, 1), (4, 8)])
            self.assertIn(f"{name}:3:1: ", str(refused.exception))

    def test_of_files_are_those_that_were_read(self):
        file = pathlib.Path("edited.toml")
        file.write_text(SMALL.text)
        scene = Scene.from_file(file)
        file.write_text(SMALL.text.replace("5.0", "6.0"))
        checks = rotatebook.render(scene, "edited", overwrite=True).verify().report["checks"]
        motion = next(check for check in checks if check["check"] == "motion")
        self.assertEqual(motion["measured"], scene.simulate().checksum)
        self.assertNotEqual(motion["measured"], Scene.from_file(file).simulate().checksum)

    def test_of_texts_and_tables_are_called_by_the_scenes_name(self):
        for scene in (SMALL, Scene.from_dict(SMALL.to_dict(), name="small")):
            with self.assertRaisesRegex(rotatebook.Error, r"^small\.toml: "):
                rotatebook.map(scene)

    def test_that_arent_made_say_why(self):
        pathlib.Path("bad.toml").write_text("[body]\nmaas = 3\n")
        with self.assertRaises(SceneError) as refused:
            rotatebook.render("bad.toml")
        self.assertEqual((refused.exception.line, refused.exception.column), (2, 1))
        with self.assertRaisesRegex(ValueError, r"^render\(\) makes a file"):
            rotatebook.render(SMALL, "-")
        with self.assertRaisesRegex(TypeError, r"^a scene is a Scene or a file's name, not a dict; Scene\.from_dict"):
            rotatebook.render({"title": "A"})
        with self.assertRaises(ProgramError) as refused:
            rotatebook.verify("bad.toml")
        self.assertEqual(refused.exception.status, 2)
        with unittest.mock.patch.dict(os.environ, {"ROTATEBOOK": "/none"}):
            with self.assertRaisesRegex(rotatebook.Error, "^ROTATEBOOK names /none, which isn't a program"):
                rotatebook.render(SMALL)

    def test_end_by_ctrl_c_at_once(self):
        script = (f"import rotatebook, time\nscene = rotatebook.Scene({SMALL.text.replace('0.5', '600')!r})\n"
                  "print('begun', flush=True)\ntry:\n    rotatebook.render(scene, 'long', overwrite=True)\n"
                  "except KeyboardInterrupt:\n    print(time.monotonic(), flush=True)\n")
        child = subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE, text=True, start_new_session=True)
        child.stdout.readline()
        until = time.monotonic() + 60
        while not (os.path.isdir("long") and os.listdir("long")) and time.monotonic() < until:
            time.sleep(0.1)
        pressed = time.monotonic()
        os.killpg(child.pid, signal.SIGINT)  # As a terminal does.
        said, _ = child.communicate(timeout=60)
        self.assertLess(float(said) - pressed, 2)  # Measured 0.02 to 0.04; the whole takes minutes.
        until = pressed + 30
        while (left := sorted(os.listdir("long"))) != ["scene.partial.mp4"] and time.monotonic() < until:
            time.sleep(0.1)
        self.assertEqual(left, ["scene.partial.mp4"])


class Exports(unittest.TestCase):
    def test_are_files_for_other_programs(self):
        exported = rotatebook.export(SMALL, "small.glb", keys=30)
        self.assertEqual((exported.file.read_bytes()[:4], exported.report["keys"], exported.notes), (b"glTF", 15, []))
        self.assertEqual(exported.report["name"], "small")
        self.assertEqual(rotatebook.export(SMALL).file, pathlib.Path("small.glb"))
        self.assertEqual(rotatebook.export(SMALL, pathlib.Path("small.usdz")).file.read_bytes()[:2], b"PK")

    def test_that_arent_made_say_why(self):
        with self.assertRaisesRegex(ProgramError, "^--keys must be a whole number from 1 to 1000, not 0"):
            rotatebook.export(SMALL, keys=0)
        with self.assertRaisesRegex(ProgramError, "must end in .glb or .usdz"):
            rotatebook.export(SMALL, "small.gltf")


class Judging(unittest.TestCase):
    def test_tells_good_engines_from_bad(self):
        motion = SMALL.simulate()[0]
        good = rotatebook.judge(motion, max_error_deg=1e-6)
        self.assertTrue(good["met"])
        slow = {"time": motion.time * 1.01, "attitude": motion.attitude}
        self.assertFalse(rotatebook.judge(slow, inertia=motion.moments, max_energy_drift=1e-6)["met"] and
                         rotatebook.judge({"time": motion.time, "attitude": motion.attitude * [1, 1, -1, 1]},
                                          inertia=motion.moments, max_error_deg=1)["met"])
        self.assertEqual(rotatebook.judge(SMALL)["motions"][0]["method"], "agrees with the exact motion")

    def test_names_rows_of_arrays(self):
        motion = SMALL.simulate()[0]
        wrong = {"time": motion.time, "attitude": motion.attitude.copy()}
        wrong["attitude"][3] *= 2
        with self.assertRaisesRegex(ProgramError, r"^the table, row 3: the quaternion's norm is 2") as refused:
            rotatebook.judge(wrong, inertia=motion.moments)
        self.assertEqual(refused.exception.status, 2)
        with self.assertRaisesRegex(ProgramError, "^the table: a single row"):
            rotatebook.judge({name: array[:1] for name, array in wrong.items()}, inertia=motion.moments)
        with self.assertRaisesRegex(ValueError, r"^attitude has the shape \(30, 4\), not \(29, 4\): a row for each time"):
            rotatebook.judge({"time": motion.time[1:], "attitude": motion.attitude}, inertia=motion.moments)
        with self.assertRaisesRegex(ValueError, "there is no attitude"):
            rotatebook.judge({"time": motion.time}, inertia=motion.moments)

    def test_studies_maps_and_tosses(self):
        study = rotatebook.study(SMALL, "studies", integrators="rk4", steps="4,8,16,32")
        scene = Scene(SMALL.text.replace("[clip]", 'tilt = ["1 deg", "z"]\n[clip]') + '[map]\nsize = [4, 3]\nmeasure = "half_turns"\n'
                      'x = { key = "initial.tilt.0", from = 0.001, to = 0.1 }\n'
                      'y = { key = "initial.angular_velocity.0", from = 4, to = 6 }\n', name="tiny")
        report, values = rotatebook.map(scene, "maps", overwrite=True)
        self.assertEqual((values.shape, values.dtype), ((3, 4), np.float64))
        columns = [f"w{axis}=Kreisel {axis}" for axis in "xyz"]
        tossed = rotatebook.toss(SOURCE / "scenes/comparisons/tossed-book.csv", list=True, column=columns, rates="rad/s")
        self.assertEqual((list(report), list(study), list(tossed)),
                         (["interrupted", "maps"], ["interrupted", "studies"], ["name", "throws"]))


if __name__ == "__main__":
    unittest.main()
