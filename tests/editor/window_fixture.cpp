#include "window_fixture.h"

#include "ui/viewport/viewport.h"

#include "core/preset/library.h"

#include <QAbstractButton>

namespace fumage::tests {

/// How long a busy machine may take for a picture.
static constexpr int kPictureMs = 20000;

Preset smallPreset()
{
    Preset preset;
    preset.name = "Small";
    preset.scene.layers[0].emitter.count = 1500;
    preset.scene.layers[0].look.size = 0.5F;
    preset.scene.layers[0].turbulence.octaves = 2;
    preset.scene.light.resolution = 24;
    preset.scene.layers[0].noise.resolution = 32;
    preset.scene.layers[0].noise.slices = 8;
    preset.scene.wind.strength = 0.8F;
    preset.scene.timeline.length = 60;
    return preset;
}

void pressButton(QMessageBox& box, QMessageBox::StandardButton button)
{
    box.button(button)->click(); // with the mouse it would be lost on a box that is not on the screen yet
}

void WindowFixture::init()
{
    const auto chooseFile = [this](QWidget*, const FileQuestion& question) {
        m_fileQuestions += question;
        return m_chosenFile;
    };
    const auto choose = [this](QWidget*, const ChoiceQuestion& question) {
        m_choiceQuestions += question;
        return static_cast<int>(m_chosenAnswer < 0 ? question.answers.size() - 1 : m_chosenAnswer);
    };
    m_session = std::make_unique<Session>(chooseFile, choose);
    m_session->settings().setList(u"exports/choices"_q, {}); // of the test before
    m_window = m_session->openWindow();
    m_window->player().pause();
    m_window->document().load(smallPreset(), {});
    m_window->player().setFrame(30);
    QVERIFY(QTest::qWaitForWindowActive(m_window));
    QTRY_VERIFY_WITH_TIMEOUT(m_window->viewport().isSettled(), kPictureMs);
}

void WindowFixture::cleanup()
{
    m_session.reset();
    m_chosenFile.clear();
    m_fileQuestions.clear();
    m_chosenAnswer = -1;
    m_choiceQuestions.clear();
    QDir(toQString(userPresetFolder().string())).removeRecursively();
    QDir(m_folder.path()).removeRecursively();
    QDir().mkpath(m_folder.path());
}

QImage WindowFixture::settled()
{
    const Viewport& viewport = m_window->viewport();
    if (!QTest::qWaitFor([&] { return viewport.isSettled(); }, kPictureMs)) {
        qWarning("the picture did not settle");
        return {};
    }
    return viewport.picture()->image;
}

MainWindow* WindowFixture::otherWindow() const
{
    for (QWidget* widget : QApplication::topLevelWidgets()) {
        auto* window = qobject_cast<MainWindow*>(widget);
        if (window != nullptr && window != m_window) {
            return window;
        }
    }
    return nullptr;
}

} // namespace fumage::tests
