from enum import Enum
from typing import Any, Optional, Sequence

import numpy as np

def version() -> str: ...
def method_names() -> list[str]: ...
def cause_name(cause: int) -> str: ...

class Camera:
    name: str
    perspective: bool
    world_from_camera: np.ndarray
    fov_y_rad: float
    height: float
    near_depth: Optional[float]
    far_depth: Optional[float]
    aperture_radius: float
    focus: Optional[float]
    blades: int
    blade_turn_rad: float
    aspect_ratio: Optional[float]
    follows: int

def fitted(camera: Camera, aspect_ratio: float, fit: str = ...) -> Camera: ...
def aperture_of_f_stop(f_stop: float, fov_y_rad: float) -> float: ...
def look_at(
    eye: Sequence[float], target: Sequence[float], fov_y_rad: float = ...
) -> Camera: ...

class LightType(Enum):
    point = ...
    spot = ...
    directional = ...
    linear = ...
    rectangle = ...
    disk = ...

class Light:
    name: str
    type: LightType
    color: Sequence[float]
    intensity: float
    position: Sequence[float]
    direction: Sequence[float]
    range: float
    inner_cone_rad: float
    outer_cone_rad: float
    radius: float
    angular_diameter_rad: float
    half_u: Sequence[float]
    half_v: Sequence[float]
    two_sided: bool
    casts_shadows: bool

class Material:
    name: str
    base_color: Sequence[float]
    base_color_image: int
    metallic: float
    roughness: float
    emissive: Sequence[float]
    ior: float
    transmission: float
    thickness: float
    blended: bool
    double_sided: bool
    unlit: bool

class AnimationInfo:
    @property
    def name(self) -> str: ...
    @property
    def seconds(self) -> float: ...

class Progress:
    @property
    def running(self) -> bool: ...
    @property
    def paused(self) -> bool: ...
    @property
    def finished(self) -> bool: ...
    @property
    def failed(self) -> bool: ...
    @property
    def fraction(self) -> float: ...
    @property
    def seconds(self) -> float: ...
    @property
    def seconds_left(self) -> Optional[float]: ...

# Used by the package alone.
class SceneBuilder:
    def __init__(self, name: str) -> None: ...
    def __getattr__(self, name: str) -> Any: ...

class SessionHandle:
    def __getattr__(self, name: str) -> Any: ...

def setting_list() -> list[tuple[str, str, str, list[str], float, float]]: ...
def layer_list() -> list[tuple[str, int, str, str, bool]]: ...
def compare(picture: Any, reference: Any) -> tuple[float, ...]: ...
def load(*arguments: Any) -> Any: ...
def render(*arguments: Any) -> Any: ...
def trace(*arguments: Any) -> Any: ...
