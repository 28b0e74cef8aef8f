#include "ui/panels/editor_factory.h"

#include "ui/panels/colour_editor.h"
#include "ui/panels/curve_editor.h"
#include "ui/panels/gradient_editor.h"
#include "ui/panels/picture_editor.h"
#include "ui/panels/simple_editors.h"
#include "ui/panels/vector_editors.h"

namespace fumage::ui {

ParameterEditor* makeEditor(const Parameter& parameter, QWidget* parent)
{
    switch (parameter.kind) {
    case Kind::Bool: return new BoolEditor(parameter, parent);
    case Kind::Choice: return new ChoiceEditor(parameter, parent);
    case Kind::Seed: return new SeedEditor(parameter, parent);
    case Kind::Direction: return new DirectionEditor(parameter, parent);
    case Kind::Vector: return new VectorEditor(parameter, parent);
    case Kind::Colour: return new ColourEditor(parameter, parent);
    case Kind::Curve: return new CurveEditor(parameter, parent);
    case Kind::Gradient: return new GradientEditor(parameter, parent);
    case Kind::Picture: return new PictureEditor(parameter, parent);
    case Kind::Int:
    case Kind::Float: break;
    }
    return new NumberEditor(parameter, parent);
}

} // namespace fumage::ui
