#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""The page of `dot_run --player` in headless Chromium: it is loaded, stepped and clicked, and what it then shows is
compared with the data in it. Pictures of it are left in OUT.

usage: player_test.py DOT_RUN SAMPLE_DIR CHROMIUM OUT
"""
import json
import os
import re
import shutil
import struct
import subprocess
import sys
import unittest
import zlib

from browser import Browser

# A name that would show if it were taken as HTML.
NAME = '<i>a & "b"<'
LOST = 12


def data_of(path):
    with open(path, encoding="utf-8") as file:
        text = file.read()
    frames = re.findall(r'<script type="application/json" class="frame">(.*?)</script>', text)
    return [json.loads(frame) for frame in frames]


def edit_page(path, pattern, replacement):
    with open(path, encoding="utf-8") as file:
        text = re.sub(pattern, replacement, file.read())
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def write_black(path, width, height):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0)) +
                   chunk(b"IDAT", zlib.compress(bytes((width + 1) * height))) + chunk(b"IEND", b""))


def make_sequence(folder, frames, masks=True, black=None):
    """A copy of the sample's first frames; that of number `black` is dark."""
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    shutil.copy(f"{SAMPLE}/intrinsics.txt", folder)
    with open(f"{SAMPLE}/times.txt") as times, open(f"{folder}/times.txt", "w") as out:
        out.writelines(times.readlines()[:frames])
    for kind in ["rgb", "depth"] + ["masks"] * masks:
        os.mkdir(f"{folder}/{kind}")
        for i in range(frames):
            name = f"{kind}/{i:06d}.png"
            if os.path.exists(f"{SAMPLE}/{name}"):
                shutil.copy(f"{SAMPLE}/{name}", f"{folder}/{name}")
    if black is not None:
        write_black(f"{folder}/rgb/{black:06d}.png", 620, 188)


def page_of(name, frames, *options, **sequence):
    make_sequence(f"{OUT}/{name}", frames, **sequence)
    page = f"{OUT}/page.html"
    subprocess.run([DOT_RUN, f"{OUT}/{name}", "--player", page, *options], check=True, stdout=subprocess.DEVNULL)
    return page


class Whole(unittest.TestCase):
    """A page of 24 frames, in one of which the camera is lost, with masks in every second."""

    @classmethod
    def setUpClass(cls):
        cls.page = page_of(NAME, 24, "--mask-every", "2", black=LOST)
        cls.data = data_of(cls.page)
        cls.browser = Browser(CHROMIUM)
        cls.browser.open(cls.page)

    @classmethod
    def tearDownClass(cls):
        cls.browser.close()

    def setUp(self):
        self.browser.value("document.activeElement.blur(), scrollTo(0, 0)")
        self.browser.key("Escape")
        self.browser.key("Home")

    def tearDown(self):
        self.assertEqual(self.browser.complaints, [])
        self.assertEqual([url for url in self.browser.requests if not url.startswith(("data:", "file:"))], [])

    def shows_frame(self, number):
        self.assertRegex(self.browser.text("#frame-title"), rf"^Frame {number}, ")
        self.assertEqual(self.browser.value("document.getElementById('image').alt"), f"frame {number}")
        self.assertEqual(self.browser.value("document.querySelector('#timeline input').value"), str(number))

    def go(self, number):
        self.browser.key("Home")
        for _ in range(number // 10):
            self.browser.key("ArrowRight", "shift")
        for _ in range(number % 10):
            self.browser.key("ArrowRight")
        self.shows_frame(number)

    def objects(self, number):
        return {o["id"]: o for o in self.data[number]["objects"]}

    def click_pixel(self, x, y):
        self.browser.click_on("#picture", (x + 0.5) / 620, (y + 0.5) / 188)

    def count(self, selector):
        return self.browser.value(f"document.querySelectorAll({json.dumps(selector)}).length")

    def attribute(self, selector, name):
        return self.browser.value(f"document.querySelector({json.dumps(selector)}).getAttribute({json.dumps(name)})")

    def selected_rows(self):
        return self.browser.value("[...document.querySelectorAll('#table tr.selected')].map(r => r.dataset.id)")

    def test_names_are_text(self):
        self.assertEqual(self.browser.text("#title"), NAME)
        self.assertEqual(self.browser.value("document.title"), NAME)
        self.assertEqual(self.count("#title i"), 0)

    def test_keys_step(self):
        self.shows_frame(0)
        for key, modifiers, frame in [("ArrowLeft", [], 0), ("ArrowRight", [], 1), ("ArrowRight", ["shift"], 11),
                                      ("ArrowLeft", [], 10), ("End", [], 23), ("ArrowRight", [], 23),
                                      ("ArrowLeft", ["shift"], 13), ("Home", [], 0)]:
            self.browser.key(key, *modifiers)
            self.shows_frame(frame)

    def test_each_frame_has_its_picture(self):
        sources = set()
        for number in range(24):
            self.shows_frame(number)
            sources.add(self.browser.value("document.getElementById('image').src"))
            self.assertEqual(self.browser.value("document.getElementById('image').decode().then(() => "
                                                "document.getElementById('image').naturalWidth)"), 620)
            self.browser.key("ArrowRight")
        self.assertEqual(len(sources), 24)

    def test_buttons_and_timeline(self):
        self.browser.click_on("#forward")
        self.shows_frame(1)
        self.browser.click_on("#last")
        self.shows_frame(23)
        self.browser.click_on("#back")
        self.shows_frame(22)
        self.browser.click_on("#timeline svg", 7.5 / 24)
        self.shows_frame(7)
        self.browser.click_on("#first")
        self.shows_frame(0)

    def test_click_on_an_object_selects_it(self):
        number = 7
        self.go(number)
        clicked = 0
        for identity, o in self.objects(number).items():
            if o["area"] == 0 or "texture" not in o:
                continue
            clicked += 1
            self.click_pixel(*o["texture"][:2])
            self.assertEqual(self.selected_rows(), [str(identity)])
            self.assertEqual(self.browser.text("#why"), o["why"])
            self.assertRegex(self.browser.text("#object-title"), rf"^Object {identity}: ")
            for plot in ("speed", "p", "phi", "range"):
                self.assertEqual(self.count(f"#plot-{plot} line.now"), 1)
            self.assertEqual(self.count("#overlay path.selected"), 1)
        self.assertGreater(clicked, 1, "the data")
        self.click_pixel(2, 2)
        self.assertEqual(self.selected_rows(), [])
        self.assertEqual(self.count("#plots svg"), 0)

    def test_table_says_what_the_frame_says(self):
        number = 9
        self.go(number)
        rows = self.browser.value("[...document.querySelectorAll('#table tbody tr')].map(r => "
                                  "[...r.cells].map(c => c.textContent))")
        shown = {int(row[0]): row for row in rows}
        self.assertEqual(set(shown), {o["id"] for frame in self.data for o in frame["objects"]})
        names = {"moving": "moving", "static": "static", "unobservable": "not decided"}
        for identity, o in self.objects(number).items():
            row = shown[identity]
            self.assertEqual(row[2], names[o["state"]])
            self.assertAlmostEqual(float(row[3]), o["p"], delta=0.0051)
            self.assertEqual(row[7], o["words"])
            speed, sigma = ("pointSpeed", "pointSigma") if "turning" in o else ("speed", "sigma")
            for cell, name in ((4, speed), (5, sigma), (6, "range")):
                self.assertEqual(row[cell] == "", name not in o)
                if name in o:
                    self.assertAlmostEqual(float(row[cell]), o[name], delta=0.051)

    def test_row_selects_and_why_follows_the_frame(self):
        identity = next(iter(self.objects(5)))
        self.browser.click_on(f"#table tr[data-id='{identity}']")
        self.assertEqual(self.selected_rows(), [str(identity)])
        for number in range(24):
            o = self.objects(number).get(identity)
            self.assertEqual(self.browser.text("#why"), o["why"] if o else "")
            self.browser.key("ArrowRight")

    def test_plot_leads_to_the_frame(self):
        self.browser.key("ArrowDown")
        self.assertEqual(len(self.selected_rows()), 1)
        self.browser.click_on("#plot-p", (44 + (640 - 52) * 17.5 / 24) / 640)
        self.shows_frame(17)

    def test_changes_of_state(self):
        def changes_of(identity):
            states = [self.objects(i).get(identity, {}).get("state") for i in range(24)]
            return [i for i in range(1, 24) if states[i] not in (None, states[i - 1])]

        identity, changes = max(((i, changes_of(i)) for i in self.objects(8)), key=lambda pair: len(pair[1]))
        self.assertGreater(len(changes), 0, "the data")
        self.browser.click_on(f"#table tr[data-id='{identity}']")
        self.browser.value("document.activeElement.blur()")
        for change in changes:
            self.browser.key("n")
            self.shows_frame(change)
        for change in changes[-2::-1]:
            self.browser.key("p")
            self.shows_frame(change)

    def test_layers(self):
        number = 8  # it has masks
        self.go(number)
        objects = [o for o in self.objects(number).values() if o["area"] > 0]
        self.assertGreater(len({o["state"] for o in objects}), 1, "the data")
        for layer, state in enumerate(("moving", "static", "unobservable"), 1):
            there = sum(o["state"] == state for o in objects)
            self.assertEqual(self.count(f"#overlay path.object.{state}"), there)
            self.browser.key(str(layer))
            self.assertEqual(self.count(f"#overlay path.object.{state}"), 0)
            self.browser.key(str(layer))
        self.assertEqual(self.count("#overlay path.object"), len(objects))
        self.assertEqual(self.count("#overlay text"), len(objects))
        for key, name, there in (("4", "network", len(self.data[number]["network"])),
                                 ("5", "predicted", sum("predicted" in o for o in self.objects(number).values()))):
            self.assertGreater(there, 0)
            self.assertEqual(self.count(f"#overlay path.{name}"), 0)
            self.browser.key(key)
            self.assertEqual(self.count(f"#overlay path.{name}"), there)
        self.browser.key("ArrowRight")
        self.assertEqual(self.count("#overlay path.network"), 0, "a frame without masks")
        self.browser.key("4")
        self.browser.key("5")
        self.assertEqual(self.count("#overlay path.texture"), 0)
        self.browser.click_on("#layer-texture")
        self.assertGreater(self.attribute("#overlay path.texture", "d").count("M"), 100)
        self.browser.click_on("#layer-texture")
        self.browser.value("document.activeElement.blur()")

    def test_outlines_lie_on_the_picture(self):
        self.go(7)
        boxes = self.browser.value("['image', 'overlay'].map(i => { const b = document.getElementById(i)"
                                   ".getBoundingClientRect(); return [b.left, b.top, b.width, b.height]; })")
        for a, b in zip(*boxes):
            self.assertAlmostEqual(a, b, delta=1.5)

    def test_lost_camera(self):
        self.assertEqual([f["frame"] for f in self.data if f["camera"]["status"] == "lost"], [LOST], "the data")
        self.assertEqual(self.browser.text("#lost"), f"Camera's motion not found: frame {LOST}.")
        self.assertEqual(self.count("#timeline rect.lost"), 1)
        self.assertEqual(self.attribute("#timeline rect.lost", "x"), str(LOST))
        self.go(LOST)
        self.assertEqual(self.browser.value("document.getElementById('camera').className"), "bad")
        self.assertIn("not found", self.browser.text("#camera"))
        self.assertTrue(any(o["words"] == "the camera's motion was not found" for o in self.data[LOST]["objects"]))
        self.assertEqual(self.browser.text("#revised"), "", "the data")
        self.assertEqual(self.count("#timeline rect.revised"), 0)

    def test_play_and_pause(self):
        self.browser.value("document.getElementById('rate').value = '2'")
        self.browser.key(" ")
        self.assertEqual(self.browser.text("#play"), "Pause")
        self.browser.wait("view.index > 3")
        self.browser.key(" ")
        self.assertEqual(self.browser.text("#play"), "Play")
        number = self.browser.value("view.index")
        self.browser.value("new Promise(done => setTimeout(done, 300))")
        self.shows_frame(number)
        self.browser.key(" ")
        self.browser.key("ArrowRight")
        self.assertEqual(self.browser.text("#play"), "Play", "a step pauses")
        self.browser.key("End")
        self.browser.key("ArrowLeft")
        self.browser.key(" ")
        self.browser.wait("document.getElementById('play').textContent === 'Play'")
        self.shows_frame(23)

    def test_help(self):
        self.browser.key("?")
        self.assertTrue(self.browser.value("document.getElementById('help').open"))
        self.browser.key("ArrowRight")
        self.shows_frame(0)
        self.browser.picture(f"{OUT}/help.png")
        self.browser.click_on("#help button")
        self.assertFalse(self.browser.value("document.getElementById('help').open"))

    def test_address_leads_back(self):
        self.go(6)
        self.browser.key("ArrowDown")
        identity = self.selected_rows()[0]
        self.browser.wait(f"location.hash === '#frame=6&object={identity}'")
        self.browser.value("location.hash = '#frame=9'")
        self.browser.wait("document.getElementById('frame-title').textContent.startsWith('Frame 9,')")
        self.assertEqual(self.selected_rows(), [])

    def test_only_those_in_this_frame(self):
        late = next(i for i in (o["id"] for f in self.data for o in f["objects"]) if i not in self.objects(0))
        row = f"document.querySelector('#table tr[data-id=\"{late}\"]').hidden"
        self.assertFalse(self.browser.value(row))
        self.browser.click_on("#present-only")
        self.assertTrue(self.browser.value(row))
        self.browser.click_on("#present-only")
        self.browser.value("document.activeElement.blur()")

    def test_pictures(self):
        self.go(9)
        self.browser.key("ArrowDown")
        self.browser.picture(f"{OUT}/light.png")
        with Browser(CHROMIUM, dark=True) as dark:
            dark.open(self.page)
            colours = [b.value("getComputedStyle(document.body).backgroundColor") for b in (self.browser, dark)]
            self.assertNotEqual(colours[0], colours[1])
            dark.key("ArrowDown")
            dark.key("ArrowRight", "shift")
            for layer in "456":
                dark.key(layer)
            dark.picture(f"{OUT}/dark.png")
        with Browser(CHROMIUM, width=420, height=1400) as narrow:
            narrow.open(self.page)
            narrow.key("ArrowDown")
            narrow.picture(f"{OUT}/narrow.png")
            self.assertLessEqual(narrow.value("document.documentElement.scrollWidth"), 420)


class Small(unittest.TestCase):
    def look_at(self, page):
        browser = Browser(CHROMIUM)
        self.addCleanup(browser.close)
        browser.open(page)
        return browser

    def test_one_frame_without_objects(self):
        browser = self.look_at(page_of("one", 1, masks=False))
        self.assertEqual(browser.text("#summary").split(", dot")[0], "1 frame, 0 objects, 620 x 188")
        for key in ("ArrowRight", "ArrowDown", "n", " ", "End"):
            browser.key(key)
        self.assertRegex(browser.text("#frame-title"), "^Frame 0, ")
        self.assertEqual(browser.text("#play"), "Play")
        self.assertEqual(browser.complaints, [])

    def test_objects_that_turn(self):
        """On the spot, by centimetres per second: no speed is shown as zero."""
        page = page_of("one", 6)
        turning = {"speed": 0, "sigma": 0.004, "fused": 0, "limit": 0.02, "pointSpeed": 0.061, "pointSigma": 0.011,
                   "turning": True}

        def turn(match):
            frame = json.loads(match.group(2))
            for o in frame["objects"]:
                if "speed" in o:
                    o.update(turning)
            return match.group(1) + json.dumps(frame) + match.group(3)

        edit_page(page, r'(<script type="application/json" class="frame">)(.*?)(</script>)', turn)
        browser = self.look_at(page)
        browser.key("End")
        moving = next(o for o in data_of(page)[5]["objects"] if o["state"] == "moving" and "speed" in o)
        names = browser.value("[...document.querySelectorAll('#overlay text')].map(t => t.textContent)")
        self.assertIn(f"#{moving['id']} 0.061 m/s", names)
        row = f"#table tr[data-id='{moving['id']}']"
        self.assertEqual([browser.text(f"{row} td:nth-child({i})") for i in (5, 6)], ["0.061", "0.011"])
        browser.click_on(row)
        ticks = browser.value("[...document.querySelectorAll('#plot-speed text')].map(t => t.textContent)")
        self.assertEqual(ticks[:3], ["0", "0.04", "0.08"])
        tops = browser.value("['points', 'limit', 'fused'].map(kind => "
                             "document.querySelector('#plot-speed polyline.' + kind).points[0].y)")
        self.assertEqual(sorted(tops), tops, "the points are the fastest")
        self.assertEqual(browser.complaints, [])

    def test_revised_motions(self):
        """Frame 3 shows that the motions of frames 1 and 2 were wrong."""
        page = page_of("one", 6)

        def revise(match):
            frame = json.loads(match.group(2))
            self.assertNotIn("revised", frame["camera"], "the data")
            if frame["frame"] == 3:
                frame["camera"]["revised"] = [{"frame": 1, "wrong": 0.314}, {"frame": 2, "wrong": 0.297}]
            return match.group(1) + json.dumps(frame) + match.group(3)

        edit_page(page, r'(<script type="application/json" class="frame">)(.*?)(</script>)', revise)
        browser = self.look_at(page)
        self.assertEqual(browser.text("#revised"), "Camera's motion revised later: frames 1 to 2.")
        marks = browser.value("[...document.querySelectorAll('#timeline rect.revised')].map(r => "
                              "[r.x.baseVal.value, r.width.baseVal.value, r.textContent])")
        self.assertEqual([mark[:2] for mark in marks], [[1, 1], [2, 1]])
        self.assertIn("was revised in frame 3: it was wrong by 0.31 m.", marks[0][2])
        said = []
        for _ in range(6):
            said.append((browser.text("#camera"), browser.value("document.getElementById('camera').className")))
            browser.key("ArrowRight")
        for number, wrong in ((1, "0.31"), (2, "0.30")):
            self.assertIn(f"Its motion was revised in frame 3: it was wrong by {wrong} m.", said[number][0])
        self.assertIn("It shows that the camera's motion in frames 1 to 2 was wrong.", said[3][0])
        self.assertEqual([name for _, name in said], ["", "bad", "bad", "", "", ""])
        for number in (0, 4, 5):
            self.assertNotIn("wrong", said[number][0])
        browser.key("Home")
        browser.key("ArrowRight")
        browser.picture(f"{OUT}/revised.png")
        self.assertEqual(browser.complaints, [])

    def test_late_masks(self):
        # Frame 0's masks come after frame 3, those of frame 4 not before the end.
        browser = self.look_at(page_of("late", 6, "--mask-every", "4", "--mask-delay", "3"))
        self.assertIn("came too late for its result", browser.text("#camera"))
        for _ in range(4):
            browser.key("ArrowRight")
        self.assertIn("came too late for its result", browser.text("#camera"))
        browser.key("ArrowLeft")
        self.assertIn("No masks came with this frame", browser.text("#camera"))

    def test_no_frames(self):
        page = page_of("one", 1)
        edit_page(page, r'<script type="(application/json|text/plain)" class=".*?</script>\n', "")
        browser = self.look_at(page)
        self.assertEqual(browser.text("#summary"), "This run has no frames.")
        for key in ("ArrowRight", "ArrowDown", "n", " ", "End"):
            browser.key(key)
        self.assertEqual(browser.complaints, [])


if __name__ == "__main__":
    if len(sys.argv) != 5:
        sys.exit(__doc__)
    DOT_RUN, SAMPLE, CHROMIUM, OUT = sys.argv[1:]
    shutil.rmtree(OUT, ignore_errors=True)
    os.makedirs(OUT)
    unittest.main(argv=sys.argv[:1], verbosity=2)
