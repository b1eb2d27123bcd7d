#include "renderer/pyray/observer.h"

namespace asos {

const char* name_of(CellFate fate) {
  switch (fate) {
    case CellFate::uniform:
      return "uniform";
    case CellFate::cut:
      return "cut";
    case CellFate::split:
      return "split";
    case CellFate::uneven:
      return "uneven";
    case CellFate::stopped:
      return "stopped";
    case CellFate::finest:
      return "finest";
    case CellFate::sampled:
      return "sampled";
    case CellFate::saturated:
      return "saturated";
    case CellFate::by_samples:
      break;
  }
  return "by samples";
}

}  // namespace asos
