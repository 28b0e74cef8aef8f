#pragma once

#include "ui/document/file_watch.h"

#include <QObject>

namespace fumage::ui {

class DocumentFiles;
class MessageBar;

/// Tells what others have done to the file of a document, and that its work comes from a program that ended, with what
/// can be done about it.
class FileNotices : public QObject {
    Q_OBJECT

public:
    FileNotices(Document& document, DocumentFiles& files, MessageBar& bar);

    /// Looks whether the file has changed.
    void look() { m_watch.look(); }
    /// The document shows work that a program left which ended unexpectedly.
    void sayRecovered();

private:
    void follow(DiskState state);
    void takeRecovered();
    void discardRecovered();

    Document& m_document;
    DocumentFiles& m_files;
    MessageBar& m_bar;
    FileWatch m_watch;
};

} // namespace fumage::ui
