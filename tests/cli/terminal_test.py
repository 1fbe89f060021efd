# SPDX-License-Identifier: GPL-3.0-or-later
#
# Long runs: the progress line on a terminal, and signals.
from support import *

LONG = ["mesh", "in.poly", "-o", "out.vtu", "--report", "out.json", "--max-area", "1e-8"]


class Terminal(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("in.poly", square)

    def test_a_terminal_shows_progress_and_is_left_clean(self):
        run = self.on_terminal(*LONG, "--time-limit", "1.2")
        self.assertEqual(run.code, UNMET)
        self.assertRegex(run.err, r"\rdelref: refining, [\d,]+ vertices, [\d,]+ waiting, \d+\.\d s\x1b\[K")
        self.assertTrue(run.err.endswith("\r\x1b[K"), repr(run.err))
        self.assertLessEqual(run.err.count("refining"), 12)

    def test_a_pipe_shows_no_progress(self):
        self.assertEqual(self.run_program(*LONG, "--time-limit", "0.6", expect=UNMET).err, "")

    def test_quiet_shows_no_progress(self):
        self.assertNotIn("\r\x1b", self.on_terminal(*LONG, "--time-limit", "0.6", "--quiet").err.replace("\r\n", ""))

    def test_a_short_run_shows_no_progress(self):
        self.assertEqual(self.on_terminal("mesh", "in.poly", "-o", "out.vtu").err.replace("\r\x1b[K", ""), "")


class Signals(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("in.poly", square)

    def interrupted(self, signal_number):
        run = self.on_terminal(*LONG, send=signal_number, when="refining")
        self.assertEqual(run.code, INTERRUPTED, str(run))
        self.assertIn("Interrupted", run.out)
        self.assertEqual(json.loads(self.read("out.json"))["outcome"]["stopped_by"], "interrupted")
        self.run_program("verify", "in.poly", "out.vtu", "--report", "out.json")

    def test_an_interrupt_leaves_a_valid_mesh(self):
        self.interrupted(signal.SIGINT)

    def test_a_request_to_terminate_leaves_a_valid_mesh(self):
        self.interrupted(signal.SIGTERM)

    def test_an_interrupt_before_there_is_a_mesh_leaves_nothing_and_says_so(self):
        self.write("in.poly", blob(300000))
        run = self.on_terminal(*LONG, send=signal.SIGINT, when="reading|checking|refining")
        self.assertEqual(run.code, INTERRUPTED, str(run))
        self.assertEqual("nothing was written" in run.err, not self.exists("out.vtu"))
        self.assertEqual([name for name in os.listdir(self.folder) if name.endswith(".partial")], [])

    def test_a_second_interrupt_gives_up_the_writing_and_leaves_nothing_incomplete(self):
        run = self.on_terminal(*LONG, send=signal.SIGINT, when="refining, [\\d,]{7}", times=2)
        self.assertEqual(run.code, INTERRUPTED, str(run))
        self.assertLess(run.seconds_after_signal, 2)
        self.assertEqual("interrupted again" in run.err, not self.exists("out.vtu"), str(run))
        self.assertEqual([name for name in os.listdir(self.folder) if name.endswith(".partial")], [])

    def test_any_more_interrupts_end_the_program_too(self):
        run = self.on_terminal(*LONG, send=signal.SIGINT, when="refining", times=1000)
        self.assertIn(run.code, (-signal.SIGINT, INTERRUPTED))

    def test_an_interrupt_that_was_ignored_at_the_start_stays_ignored(self):
        process = self.start(*LONG, "--time-limit", "1", stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                             preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_IGN))
        time.sleep(0.5)
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=240)
        self.assertEqual(process.returncode, UNMET)

    def test_a_verification_can_be_interrupted(self):
        self.run_program("mesh", "in.poly", "-o", "out.vtu", "--max-area", "5e-6")
        run = self.on_terminal("verify", "in.poly", "out.vtu", "--max-area", "5e-6", send=signal.SIGINT, when="reading|verifying")
        self.assertIn(run.code, (INTERRUPTED, OK))
        if run.code == INTERRUPTED:
            self.assertIn("not checked to the end", run.err)


if __name__ == "__main__":
    main()
