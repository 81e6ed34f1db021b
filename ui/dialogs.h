// Questions that the window asks: where to save, what to do with changes, what to record.
#pragma once

#include "ui/workbench.h"

namespace ember {

class Dialogs {
  public:
    /// Lays out those that are open.
    void draw(Workbench& bench);

  private:
    void save_as(Workbench& bench);
    void open_path(Workbench& bench);
    void leaving(Workbench& bench);
    void record(Workbench& bench);
    void stopped(Workbench& bench);
    char name_[256] = "", path_[1024] = "";
    RecordingOptions options_;
    bool asked_name_ = false, asked_path_ = false, asked_record_ = false;
};

}  // namespace ember
