"""The plots of speed.py, drawn by gnuplot."""
import os
import subprocess
import sys

SHEET = """set terminal pngcairo size {width},700 font 'sans,15' linewidth 1.5 background rgb 'white'
set output '{output}'
set border 31 linecolor rgb '#606060'
set grid linecolor rgb '#e4e4e4'
set key top left Left reverse
"""

RESOLUTION = """set title 'Speed by size, PNGs and MP4 both written'
set xlabel 'pixels of a picture  [millions]'
set ylabel 'frames a second'
set logscale xy
set xrange [0.15:24]
set xtics (0.25, 0.5, 1, 2, 4, 8)
set yrange [*:*]
set key off
plot $rows using 2:3 with linespoints linecolor rgb '#0072b2' pointtype 7, \\
     $rows using 2:3:1 with labels left offset 0.6,0.7 noenhanced
"""

COUNT = """set xrange [0:*]
set yrange [0:*]
set xlabel 'frames of 1280x720'
set multiplot layout 1,2 title 'Time and memory by length of the clip'
set ylabel 'time  [s]'
plot $rows using 1:2 with linespoints linecolor rgb '#0072b2' pointtype 7 notitle
set ylabel 'peak memory  [MB]'
plot $rows using 1:3 with linespoints linecolor rgb '#d55e00' pointtype 7 notitle
unset multiplot
"""


def plot(rows, commands, output, width):
    """Draws one PNG; stops everything, with gnuplot's words, if that fails."""
    data = "$rows << END\n" + "".join(" ".join(map(str, row)) + "\n" for row in rows) + "END\n"
    try:
        result = subprocess.run(["gnuplot", "-d"], input=SHEET.format(width=width, output=output) + data + commands,
                                capture_output=True, text=True, check=False)
    except FileNotFoundError:
        sys.exit("speed.py: can't draw the plots: gnuplot isn't installed; apt-get install gnuplot-nox")
    if result.returncode != 0:
        sys.exit(f"speed.py: gnuplot can't draw {output}: {result.stderr}")
    return output


def draw(sizes, counts, folder):
    """Returns the files, made in `folder`."""
    os.makedirs(folder, exist_ok=True)
    return [plot(sizes, RESOLUTION, os.path.join(folder, "resolution.png"), 900),
            plot(counts, COUNT, os.path.join(folder, "frames.png"), 1400)]
