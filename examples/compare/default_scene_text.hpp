// The text of the embedded scene.
#pragma once

#include <string_view>

namespace compare {

// examples/scenes/pool_break.json as it was when the program was built.
[[nodiscard]] std::string_view default_scene_text() noexcept;

} // namespace compare
