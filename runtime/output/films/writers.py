"""Files of a film: GIF by Pillow, MP4 by ffmpeg, HTML with a player, by Matplotlib's writers."""

from __future__ import annotations

import base64
import io
import re
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib import animation
from matplotlib.colors import to_rgb
from PIL import Image

from hertzwerk.derive.common.faults import Fault
from hertzwerk.runtime.output.drawings.drawing_primitives import INK
from hertzwerk.runtime.output.plots.plot_style import CYCLE, GREY

TICK = 10  # ms: the unit of a GIF's times
GREYS, TINTS, SHADES = 32, 24, (0.25, 0.5, 0.75, 0.88)  # of a GIF's 256 colours
PALEST = 0.12  # strength of a tint: Pillow would take a paler one for white
ICONS = {
    "minus": "&minus;", "plus": "+", "fast-backward": "|&#9664;", "step-backward": "&#9664;|", "play fa-flip-horizontal": "&#9664;",
    "pause": "&#10074;&#10074;", "play": "&#9654;", "step-forward": "|&#9654;", "fast-forward": "&#9654;|",
}  # fmt: skip


class GifWriter(animation.PillowWriter):
    """Pillow's writer, with frames in 256 colours and times that add up to those of the film."""

    _frames: list[Any]

    def grab_frame(self, **savefig_kwargs: Any) -> None:
        """Take the figure as it is."""
        self._frames.append(_image(self).convert("RGB").quantize(palette=_palette(), dither=Image.Dither.NONE))

    def finish(self) -> None:
        """Write the file."""
        ends = [round((k + 1) * 1000 / self.fps / TICK) * TICK for k in range(len(self._frames))]
        shown = [end - begin for begin, end in zip([0, *ends], ends, strict=False)]
        first, *others = self._frames
        first.save(self.outfile, save_all=True, append_images=others, duration=shown, loop=0, optimize=False)


def _image(writer: animation.AbstractMovieWriter) -> Image.Image:
    """Return the figure as it is, RGBA."""
    canvas = io.BytesIO()
    writer.fig.savefig(canvas, format="rgba", dpi=writer.dpi)
    return Image.frombuffer("RGBA", writer.frame_size, canvas.getvalue(), "raw", "RGBA", 0, 1)


@cache
def _palette() -> Image.Image:
    """Return the colours of pictures with their tints, shared by all frames, which then hold changes only."""
    greys = [(level, level, level) for level in np.linspace(0, 255, GREYS).round().astype(int)]
    tints = [
        tuple(round(255 * (1 - strength * (1 - part))) for part in to_rgb(colour))
        for colour in dict.fromkeys((*CYCLE, GREY, INK))
        for strength in np.linspace(1, PALEST, TINTS)
    ]
    shades = [tuple(round(255 * darker * part) for part in to_rgb(colour)) for colour in CYCLE for darker in SHADES]
    image = Image.new("P", (1, 1))
    image.putpalette(np.ravel([*greys, *tints, *shades]).astype(np.uint8).tobytes())
    return image


class PlayerWriter(animation.HTMLWriter):
    """Matplotlib's player with its frames in the file, which fetches nothing.

    A frame is clear where it is as the first, which lies behind it.
    """

    _saved_frames: list[str]
    _first: np.ndarray

    def grab_frame(self, **savefig_kwargs: Any) -> None:
        """Take what differs from the first frame."""
        image, content = np.array(_image(self)), io.BytesIO()
        if self._saved_frames:
            image[np.all(image == self._first, axis=2)] = 0
        else:
            self._first = image
        Image.fromarray(image).save(content, "png")
        self._saved_frames.append(base64.encodebytes(content.getvalue()).decode("ascii"))

    def finish(self) -> None:
        """Write the file."""
        super().finish()
        path = Path(self.outfile)
        page = re.sub(r"<link rel=\"stylesheet\"\s+href=\"http[^>]*>", "", path.read_text(encoding="utf-8"))
        page = re.sub(r"<i class=\"fa fa-([a-z -]+)\"></i>", lambda icon: ICONS[icon[1]], page)
        first = self._saved_frames[0].replace("\n", "")
        head = f'<!DOCTYPE html>\n<meta charset="utf-8">\n<title>{path.stem}</title>\n'
        style = f"<style>.animation img {{ background: url(data:image/png;base64,{first}) 0 0 / 100% 100%; }}</style>\n"
        path.write_text(head + page + style, encoding="utf-8")


def _gif(fps: Any) -> animation.AbstractMovieWriter:
    return GifWriter(fps=fps)


def _mp4(fps: Any) -> animation.AbstractMovieWriter:
    # frames are files first: Ctrl-C, which ffmpeg would receive too, then leaves a film of those so far
    return animation.FFMpegFileWriter(fps=fps, codec="h264", extra_args=["-pix_fmt", "yuv420p"])


def _html(fps: Any) -> animation.AbstractMovieWriter:
    return PlayerWriter(fps=fps, embed_frames=True, embed_limit=1e6)


WRITERS: dict[str, Callable[[float], animation.AbstractMovieWriter]] = {".gif": _gif, ".mp4": _mp4, ".html": _html}


def format_fault(path: Path) -> Fault | None:
    """Return the fault of a file's format: an unknown one, or mp4 without ffmpeg."""
    suffix = path.suffix.lower()
    if suffix not in WRITERS:
        return Fault("file", str(path), f"a name that ends in {', '.join(WRITERS)}")
    if suffix == ".mp4" and not animation.FFMpegFileWriter.isAvailable():
        remedy = "install it (Debian: apt-get install ffmpeg), or name a .gif or .html file"
        return Fault("file", f"{path}, and no program ffmpeg", "ffmpeg, which writes mp4", remedy)
    return None
