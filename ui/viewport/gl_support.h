#pragma once

namespace fumage::ui {

/// What OpenGL is good for on this machine.
enum class GlSupport {
    None, ///< no context at all: the picture is shown by a plain widget
    Software, ///< a context that the processor draws: the compositor is faster than it
    Hardware,
};

/// Tries to make an OpenGL 3.3 core context. Takes some 10 ms; call it once, on the GUI thread.
/// The environment variable FUMAGE_OPENGL=none|software|hardware answers instead where it is set.
[[nodiscard]] GlSupport probeOpenGl();

/// Whether FUMAGE_OPENGL asks for an OpenGL widget even without a graphics card.
[[nodiscard]] bool openGlIsWanted();

} // namespace fumage::ui
