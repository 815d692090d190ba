#include "sim/database/observer_packing.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

#include "firmware/arithmetic/elementary.hpp"
#include "sim/scene/placement.hpp"

namespace maquette::sim {

namespace {

/// What an eye sees one unit in front of it, or a parallel view at any distance, in the screen
/// frame.
struct Window {
  Placement from_screen;  ///< x to the right, y up, z into the scene
  double center_x = 0;
  double center_y = 0;
  double height = 1;
};

Placement screen_frame(const Vector3& right, const Vector3& up, const Vector3& forward,
                       const Vector3& eye) {
  return {right.x,   right.y,   right.z,   up.x,  up.y,  up.z,
          forward.x, forward.y, forward.z, eye.x, eye.y, eye.z};
}

/// The height of a window that holds a rectangle.
double height_around(double width, double height, const PictureFormat& format) {
  return std::max(height, width * format.height / format.width);
}

/// What an angle spans one unit in front of the eye.
double spanned(double angle_deg) {
  const double half = angle_deg / 2 * (firmware::elementary::k_pi / 180);
  return 2 * firmware::sine(half) / firmware::cosine(half);
}

/// How much larger things are on a screen at a distance than one unit in front of the eye.
double scale_at(const View& view, double distance) {
  return view.projection == firmware::Projection::parallel ? 1 : distance;
}

Window window_in_front(const View& view, const PictureFormat& format) {
  const Vector3 forward = glm::normalize(view.target - view.eye);
  const Vector3 right = glm::normalize(glm::cross(forward, view.up));
  const Vector3 up = glm::cross(right, forward);
  Window window;
  window.from_screen = screen_frame(right, up, forward, view.eye);
  if (view.height) {
    window.height = *view.height;
  } else if (view.field_of_view_deg) {
    window.height = spanned(*view.field_of_view_deg);
  } else if (view.horizontal_field_of_view_deg) {
    window.height = spanned(*view.horizontal_field_of_view_deg) * format.height / format.width;
  } else {
    const double scale = scale_at(view, view.screen->distance);
    window.height = height_around(view.screen->width / scale, view.screen->height / scale, format);
  }
  return window;
}

/// The eye looks straight at the plane of the screen, which need not lie around the foot.
Window window_placed(const View& view, const PictureFormat& format) {
  const Placement& place = *view.screen->placement;
  const Vector3 right = glm::normalize(place[0]);
  const Vector3 up = glm::normalize(place[1]);
  const Vector3 forward = -glm::cross(right, up);
  const Vector3 to_center = place[3] - view.eye;
  const double distance = scale_at(view, glm::dot(to_center, forward));
  Window window;
  window.from_screen = screen_frame(right, up, forward, view.eye);
  window.center_x = glm::dot(to_center, right) / distance;
  window.center_y = glm::dot(to_center, up) / distance;
  window.height = height_around(view.screen->width * glm::length(place[0]) / distance,
                                view.screen->height * glm::length(place[1]) / distance, format);
  return window;
}

}  // namespace

firmware::Observer<double> observer_of(const View& view, const PictureFormat& format) {
  const bool is_placed = view.screen && view.screen->placement;
  const Window window = is_placed ? window_placed(view, format) : window_in_front(view, format);
  const double step = window.height / format.height;
  firmware::Observer<double> observer{};
  observer.from_screen = window.from_screen;
  observer.to_screen = inverse_of(window.from_screen);
  observer.step = step;
  observer.left = window.center_x - step * (format.width - 1) / 2;
  observer.top = window.center_y + step * (format.height - 1) / 2;
  observer.columns = format.width;
  observer.rows = format.height;
  return observer;
}

}  // namespace maquette::sim
