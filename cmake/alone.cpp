// SPDX-License-Identifier: Apache-2.0
// The program that every library is linked into whole, with what it declares (SkeinLibrary.cmake).
int main() { return 0; }
