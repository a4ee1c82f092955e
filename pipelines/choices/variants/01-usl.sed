s/^step = .*/step = "2.5e-3 s"/
$a [method]\nupdate_order = "USL"
