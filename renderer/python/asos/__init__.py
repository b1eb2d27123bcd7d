"""Antialiasing by adaptive supersampling in object space (ASOS).

>>> import asos
>>> scene = asos.load("builtin:boxes")
>>> picture = scene.render(width=64, height=36)
>>> picture["beauty"].shape
(36, 64, 3)

Conventions are glTF's: right-handed, +Y up, metres, radians; colours are linear.
"""

from __future__ import annotations

import contextlib
import importlib
import os
import tempfile
from dataclasses import dataclass
from typing import Any, Callable, Iterator, NamedTuple, Optional, Sequence

import numpy as np

from . import _asos
from ._asos import (
    AnimationInfo,
    Camera,
    Light,
    LightType,
    Material,
    Progress,
    aperture_of_f_stop,
    fitted,
    look_at,
)
from .errors import (
    CannotOpen,
    CannotWrite,
    Cancelled,
    Error,
    InvalidArgument,
    OutOfMemory,
    Unsupported,
)
from .trace import Cell, Edge, PixelTrace, Sample, trace_from

__version__ = _asos.version()
__all__ = [
    "AnimationInfo", "Camera", "CannotOpen", "CannotWrite", "Cancelled", "Cell", "Comparison",
    "Edge", "Error", "IdShares", "InvalidArgument", "LayerInfo", "Light", "LightType", "Material",
    "Mesh", "OutOfMemory", "Picture", "PixelTrace", "Progress", "Sample", "Scene", "Setting",
    "SplitMap", "Unsupported", "Update", "aperture_of_f_stop", "compare", "fitted", "layers", "load",
    "look_at", "methods", "settings", "trace",
]  # fmt: skip


def methods() -> list[str]:
    """Return the names of all methods, "asos" first."""
    return _asos.method_names()


class Setting(NamedTuple):
    """A setting that `Scene.render` takes by its name."""

    name: str
    about: str
    usual: str  #: its default
    choices: list[str]  #: its values; empty: a number, or a sequence of them
    least: float  #: a number's range
    most: float


def settings() -> list[Setting]:
    """Return the settings beyond those that the help of `Scene.render` lists."""
    return [Setting(*row) for row in _asos.setting_list()]


class LayerInfo(NamedTuple):
    """A layer that a picture may have."""

    name: str
    channels: int
    unit: str
    about: str
    ids: bool  #: its values are numbers of objects or materials


def layers() -> list[LayerInfo]:
    """Return all layers. `Scene.render(layers=["depth", ...])` asks for others than the usual."""
    return [LayerInfo(*row) for row in _asos.layer_list()]


class IdShares(NamedTuple):
    """Which parts of pixels show which object or material. Arrays have one entry a part."""

    pixel: np.ndarray  #: y * width + x, uint32
    id: np.ndarray  #: index into `names`, or -1 for the background, int32
    share: np.ndarray  #: of the pixel's area, above 0 to 1, float32
    names: list[str]


class SplitMap(NamedTuple):
    """Which pixels are split, and why. Arrays have the shape (height, width)."""

    level: np.ndarray  #: deepest level of each pixel, uint8
    cause: np.ndarray  #: index into `names`, uint8
    names: list[str]  #: of the causes; the first one is that of pixels that are not split


class Picture:
    """A rendered picture. `picture["beauty"]` and the other `layers` are float32 arrays."""

    def __init__(self, handle: Any):
        self._handle = handle

    @property
    def width(self) -> int:
        """Pixels."""
        return self._handle.width

    @property
    def height(self) -> int:
        """Pixels."""
        return self._handle.height

    @property
    def finished(self) -> bool:
        """Whether every pixel is final."""
        return self._handle.finished

    @property
    def seconds(self) -> float:
        """Seconds of rendering, without preparation."""
        return self._handle.seconds

    @property
    def rays(self) -> int:
        """Rays of all kinds."""
        return self._handle.rays

    @property
    def layers(self) -> list[str]:
        """Names of the layers."""
        return self._handle.layer_names()

    def __getitem__(self, layer: str) -> np.ndarray:
        """Return a layer, row by row from the top: (height, width) or (height, width, channels).

        "beauty" is linear radiance. The array is the picture's own memory, for reading; "level",
        "cause" and ids are copies. Ids are those of the largest share of a pixel; -1: background.
        Raises `InvalidArgument` where there is no such layer.
        """
        return self._handle.layer(layer)

    def id_shares(self, layer: str) -> IdShares:
        """Return all shares of "object" or "material". Raises `InvalidArgument` for others."""
        return IdShares(*self._handle.id_shares(layer), self._handle.id_names(layer))

    def predicted_level(self, eps: float, max: int) -> np.ndarray:
        """Return the level of each pixel, uint8, as it would be for another EPS and MAX.

        Takes 20 ns a pixel. Raises `InvalidArgument` for pictures by other methods than ASOS.
        """
        return self._handle.predicted_level(eps, max).astype(np.uint8)

    def split_map(self) -> SplitMap:
        """Return the level and the cause of each pixel. Only pictures by ASOS are split."""
        causes = self["cause"].astype(np.uint8)
        names: list[str] = []
        while name := _asos.cause_name(len(names)):
            names.append(name)
        return SplitMap(self["level"].astype(np.uint8), causes, names)

    def save(
        self, path: str | os.PathLike, exposure_ev: float = 0.0, tone: Optional[str] = None
    ) -> None:
        """Write display values (.png), or linear radiance with all layers (.exr).

        `exposure_ev`: in stops. `tone`: "none", "neutral" or "agx"; None: that of the render.
        """
        self._handle.save(os.fspath(path), exposure_ev, tone)

    def save_split_map(self, path: str | os.PathLike, by: str = "level") -> None:
        """Write a map of the splits (.png) by "level", "cause", "rays" or "time"."""
        self._handle.save_split_map(os.fspath(path), by)

    def _repr_png_(self) -> bytes:
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "picture.png")
            self.save(path)
            with open(path, "rb") as file:
                return file.read()

    def __repr__(self) -> str:
        state = "" if self.finished else ", unfinished"
        return f"<asos.Picture {self.width} x {self.height}{state}>"


@dataclass
class Mesh:
    """A triangle mesh. `world_from_mesh` holds one 4x4 matrix for each place where it is shown."""

    positions: np.ndarray  #: (n, 3), metres
    triangles: np.ndarray  #: (m, 3), indices of vertices, counter-clockwise in front
    normals: Optional[np.ndarray] = None  #: (n, 3); None: flat faces
    uvs: Optional[np.ndarray] = None  #: (n, 2)
    colors: Optional[np.ndarray] = None  #: (n, 4), linear, 0 to 1
    material: int = 0  #: index into the scene's materials
    world_from_mesh: Sequence[np.ndarray] = ()  #: none: once, at its own place
    name: str = ""


@contextlib.contextmanager
def _bar_of(progress: Any) -> Iterator[Optional[Callable[[Progress], None]]]:
    """Yield the callback of `Scene.render`'s `progress`. True: that of a bar, if there is tqdm."""
    if not isinstance(progress, bool):
        yield progress
        return
    try:
        bar = importlib.import_module("tqdm.auto").tqdm(total=100, unit="%") if progress else None
    except ImportError:
        bar = None
    if bar is None:
        yield None
        return
    with bar:
        yield lambda state: bar.update(max(0, round(100 * state.fraction) - bar.n))


class Update(NamedTuple):
    """Tiles of a progressive picture, as `Scene.session` yields them."""

    progress: Progress
    tiles: list[tuple[int, int, int, int]]  #: x, y, width, height of each changed rectangle
    rgb: np.ndarray  #: the picture so far, (height, width, 3), linear; the next update changes it


class Scene:
    """A scene that is ready to render. Make one by `load`, or from arrays.

    `meshes`: at least one. `images`: uint8 arrays (height, width, 4), sRGB with linear alpha.
    """

    def __init__(
        self,
        meshes: Sequence[Mesh],
        materials: Sequence[Material] = (),
        lights: Sequence[Light] = (),
        cameras: Sequence[Camera] = (),
        images: Sequence[np.ndarray] = (),
        name: str = "scene",
    ):
        builder = _asos.SceneBuilder(name)
        for image in images:
            builder.add_image(image)
        for material in materials or [Material()]:
            builder.add_material(material)
        for mesh in meshes:
            number = builder.add_mesh(
                mesh.name, mesh.positions, mesh.triangles, mesh.normals, mesh.uvs, mesh.colors,
                mesh.material,
            )  # fmt: skip
            for place in mesh.world_from_mesh or [np.eye(4)]:
                builder.place_mesh(number, place, mesh.name)
        for light in lights:
            builder.add_light(light)
        for camera in cameras:
            builder.add_camera(camera)
        self._handle = builder.build()

    @classmethod
    def _of(cls, handle: Any) -> Scene:
        scene = cls.__new__(cls)
        scene._handle = handle
        return scene

    @property
    def name(self) -> str:
        """The name of the scene."""
        return self._handle.name

    @property
    def warnings(self) -> list[str]:
        """Repaired or ignored parts of the file, each as a sentence."""
        return self._handle.warnings

    @property
    def cameras(self) -> list[Camera]:
        """The cameras of the file, in its order."""
        return self._handle.cameras

    @property
    def animations(self) -> list[AnimationInfo]:
        """The animations of the file."""
        return self._handle.animations

    @property
    def triangles(self) -> int:
        """Triangles of all instances."""
        return self._handle.triangles

    def default_camera(self, aspect_ratio: float = 16 / 9) -> Camera:
        """Return the first camera, or one that frames the scene. `aspect_ratio`: width / height."""
        return self._handle.default_camera(aspect_ratio)

    def with_lights(self, lights: Sequence[Light]) -> Scene:
        """Return the same scene in other light. Geometry and materials are shared."""
        return Scene._of(self._handle.with_lights(list(lights)))

    def at(self, seconds: float, animation: str = "") -> Scene:
        """Return the scene at a moment of an animation, by number or name; "": the first.

        The file is not read again. Raises `InvalidArgument` where there is no such animation.
        """
        return Scene._of(self._handle.at(seconds, animation))

    def _camera(self, camera: Optional[Camera], settings: dict[str, Any]) -> Camera:
        if camera is not None:
            return camera
        return self.default_camera(settings.get("width", 1280) / settings.get("height", 720))

    def render(
        self,
        camera: Optional[Camera] = None,
        *,
        progress: bool | Callable[[Progress], None] | None = None,
        time_limit: Optional[float] = None,
        **settings: Any,
    ) -> Picture:
        """Render a picture and wait for it. Other threads go on; Ctrl+C stops it.

        `progress` is called about ten times a second; True shows a bar, if `tqdm` is installed.
        `time_limit`: seconds, for the best picture of that time.

        Settings and their defaults: width=1280, height=720, crop=None (x, y, width, height),
        method="asos" (see `methods`), max=4, eps=1/256, samples=16 (of sampling methods),
        texture_resolution=1, shadows=True, sky_shadows=False, bounces=0, reflections=4, sky="",
        sky_turn_deg=0, sky_brightness=1, ground="auto" ("off", "on", "mirror"), background="auto"
        ("environment", "blurred", "colours", "transparent"), background_top, background_bottom
        (r, g, b), tone="neutral" ("none", "agx"), shutter_seconds=0, layers=() (see `layers`),
        seed=0, threads=0 (one for each core). `settings` lists all others.

        Raises `InvalidArgument`, `CannotOpen` (the sky's file), `Unsupported` or `OutOfMemory`.
        """
        with _bar_of(progress) as listener:
            return Picture(
                _asos.render(
                    self._handle, self._camera(camera, settings), settings, listener, time_limit
                )
            )

    def session(self, camera: Optional[Camera] = None, **settings: Any) -> Iterator[Update]:
        """Render in the background and yield the picture as it comes, coarse pixels first.

        Settings are those of `render`. Ending the loop early cancels the render.
        """
        handle = _asos.SessionHandle()
        handle.start(self._handle, self._camera(camera, settings), settings)
        picture = handle.picture()
        rgb = np.zeros((picture.height, picture.width, 3), np.float32)
        try:
            ended = False
            while not ended:
                handle.wait(50)
                progress = handle.progress()
                ended = progress.finished or progress.failed
                tiles = handle.take_tiles(rgb)
                if tiles or ended:
                    yield Update(progress, [tuple(tile) for tile in tiles], rgb)
        finally:
            handle.cancel()

    def __repr__(self) -> str:
        return f"<asos.Scene {self.name}, {self.triangles} triangles>"


def load(
    path: str | os.PathLike,
    *,
    scene: str = "",
    variant: str = "",
    asset_root: str = "",
    animation: str = "",
    seconds: Optional[float] = None,
) -> Scene:
    """Open a .gltf or .glb file, or a built-in scene ("builtin:office").

    `scene`: of the file's scenes, by number or name. `variant`: of its materials. `asset_root`:
    folder that buffers and images may come from. `animation`, `seconds`: a moment of an animation,
    by number or name. Raises `CannotOpen` or `InvalidArgument`.
    """
    path = os.fspath(path)
    return Scene._of(_asos.load(path, scene, variant, asset_root, animation, seconds))


def trace(
    scene: Scene, x: int, y: int, camera: Optional[Camera] = None, **settings: Any
) -> PixelTrace:
    """Render the pixel (x, y) and return how it was subdivided. Settings are those of `render`."""
    # pylint: disable=protected-access
    return trace_from(
        _asos.trace(scene._handle, scene._camera(camera, settings), settings, x, y)
    )


class Comparison(NamedTuple):
    """The difference of two pictures, of linear values clipped to 0 to 1.

    A pixel's own error is the root mean square of its channels.
    """

    rmse: float
    psnr: float  #: dB for a peak of 1; infinite for equal pictures
    mean_absolute: float
    p99: float  #: 99th percentile of the pixels' errors
    worst: float  #: the largest pixel's error
    rmse_display: float  #: after the sRGB curve
    delta_e: float  #: mean CIEDE2000


def compare(picture: Picture, reference: Picture) -> Comparison:
    """Compare a picture with a reference. Raises `InvalidArgument` where their sizes differ."""
    # pylint: disable=protected-access
    return Comparison(*_asos.compare(picture._handle, reference._handle))
