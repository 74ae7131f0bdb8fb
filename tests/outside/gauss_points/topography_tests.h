#pragma once

// cmocka tests of read_topography.
void reads_rows_with_and_without_a_last_semicolon(void** state);
void refuses_files_with_line_and_reason(void** state);
